#include "core/io/property_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include "core/io/numbers.h"

namespace stipple {

namespace {

constexpr std::string_view kScalarPrefix = "scalar_";
// Names with a meaning of their own: a single number of that name keeps or gets the prefix.
constexpr std::array<std::string_view, 6> kReserved = {"x", "y", "z", "position", "normal", "color"};

class Planner {
 public:
  explicit Planner(const std::vector<RowProperty>& properties)
      : properties_(properties), used_(properties.size()) {}

  PropertyPlan plan() {
    // Names are compared pair by pair; no scanner and no spectrum has as many.
    constexpr std::size_t kMost = 4096;
    if (properties_.size() > kMost) {
      throw InvalidInput(
          fmt::format("has {} numbers a point, at most {} are read", properties_.size(), kMost));
    }
    dropRepeatedNames();
    takePosition();
    takeNormal();
    takeColor();
    for (std::size_t p = 0; p < properties_.size(); ++p) {
      if (!used_[p]) takeVectorOrNumber(p);
    }
    // Attributes stand in the order of their first property.
    std::ranges::stable_sort(plan_.attributes, {},
                             [](const auto& attribute) { return attribute.sources.front(); });
    return std::move(plan_);
  }

 private:
  std::optional<std::size_t> find(std::string_view name) const {
    for (std::size_t p = 0; p < properties_.size(); ++p) {
      if (!used_[p] && properties_[p].name == name) return p;
    }
    return std::nullopt;
  }

  // The unused properties of these names, all or none.
  std::vector<std::size_t> findAll(std::span<const std::string> names) const {
    std::vector<std::size_t> found;
    for (const std::string& name : names) {
      if (const auto p = find(name)) found.push_back(*p);
    }
    if (found.size() != names.size()) found.clear();
    return found;
  }

  void use(std::span<const std::size_t> sources) {
    for (const std::size_t p : sources) used_[p] = true;
  }

  void dropRepeatedNames() {
    std::set<std::string_view> seen;
    for (std::size_t p = 0; p < properties_.size(); ++p) {
      if (seen.insert(properties_[p].name).second) continue;
      used_[p] = true;
      plan_.warnings.push_back(
          fmt::format("property '{}' stands twice, the second is ignored", properties_[p].name));
    }
  }

  void takePosition() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view name = std::string_view("xyz").substr(axis, 1);
      const auto p = find(name);
      if (!p) throw InvalidInput(fmt::format("the points have no property '{}'", name));
      plan_.position[axis] = *p;
    }
    use(plan_.position);
  }

  void takeNormal() {
    const std::array<std::string, 3> names = {"nx", "ny", "nz"};
    const auto sources = findAll(names);
    if (sources.empty()) return;
    const bool wide = std::ranges::any_of(
        sources, [&](std::size_t p) { return properties_[p].type == ScalarType::kFloat64; });
    use(sources);
    plan_.attributes.push_back({.name = "normal",
                                .type = AttributeType::kVector3,
                                .sources = sources,
                                .file = {"normal", wide ? ScalarType::kFloat64 : ScalarType::kFloat32}});
  }

  void takeColor() {
    struct Spelling {
      std::array<std::string, 3> names;
      std::string alpha;
    };
    static const std::array<Spelling, 3> kSpellings = {
        {{{"red", "green", "blue"}, "alpha"},
         {{"diffuse_red", "diffuse_green", "diffuse_blue"}, "diffuse_alpha"},
         {{"r", "g", "b"}, "a"}}};
    for (const auto& [names, alpha] : kSpellings) {
      auto sources = findAll(names);
      if (sources.empty()) continue;
      const auto alphaSource = find(alpha);
      if (alphaSource) sources.push_back(*alphaSource);
      use(sources);
      const bool bytes = std::ranges::all_of(
          sources, [&](std::size_t p) { return properties_[p].type == ScalarType::kUint8; });
      addColor(std::move(sources), bytes ? ColorCoding::kBytes : ColorCoding::kNumbers);
      return;
    }
    // The coefficients stay attributes of their own beside the color that they show.
    const std::array<std::string, 3> coefficients = {"f_dc_0", "f_dc_1", "f_dc_2"};
    auto sources = findAll(coefficients);
    if (!sources.empty()) addColor(std::move(sources), ColorCoding::kSphericalHarmonics);
  }

  void addColor(std::vector<std::size_t> sources, ColorCoding coding) {
    const bool hasAlpha = sources.size() == 4;
    plan_.attributes.push_back({.name = "color",
                                .type = AttributeType::kColor,
                                .sources = std::move(sources),
                                .file = {"color", ScalarType::kUint8, hasAlpha},
                                .coding = coding});
  }

  bool nameIsFree(std::string_view name) const {
    return std::ranges::find(kReserved, name) == kReserved.end() &&
           std::ranges::none_of(plan_.attributes,
                                [&](const auto& attribute) { return attribute.name == name; });
  }

  // <name>_x _y _z of type float are one vector, unless the file has a number of that name too.
  bool takeVector(std::size_t p) {
    const std::string& first = properties_[p].name;
    if (!first.ends_with("_x") || first.size() < 3) return false;
    const std::string base = first.substr(0, first.size() - 2);
    const std::array<std::string, 3> names = {base + "_x", base + "_y", base + "_z"};
    const auto sources = findAll(names);
    const bool floats = std::ranges::all_of(
        sources, [&](std::size_t source) { return properties_[source].type == ScalarType::kFloat32; });
    const bool isNormal =
        base == "normal" && std::ranges::none_of(plan_.attributes, [](const auto& attribute) {
          return attribute.name == "normal";
        });
    if (sources.empty() || !floats || find(base) || find(std::string(kScalarPrefix) + base)) return false;
    if (!nameIsFree(base) && !isNormal) return false;
    use(sources);
    plan_.attributes.push_back({.name = base,
                                .type = AttributeType::kVector3,
                                .sources = sources,
                                .file = {base, ScalarType::kFloat32}});
    return true;
  }

  void takeVectorOrNumber(std::size_t p) {
    if (takeVector(p)) return;
    const RowProperty& property = properties_[p];
    std::string name = property.name;
    if (name.starts_with(kScalarPrefix) && name.size() > kScalarPrefix.size()) {
      const std::string plain = name.substr(kScalarPrefix.size());
      const bool clash =
          std::ranges::any_of(properties_, [&](const auto& other) { return other.name == plain; });
      if (!clash && nameIsFree(plain)) name = plain;
    } else if (!nameIsFree(name)) {
      name = std::string(kScalarPrefix) + name;
    }
    while (!nameIsFree(name)) name += '_';
    used_[p] = true;
    plan_.attributes.push_back({.name = name,
                                .type = numberType(property.type),
                                .sources = {p},
                                .file = {property.name, property.type}});
  }

  static AttributeType numberType(ScalarType type) {
    if (type == ScalarType::kFloat32) return AttributeType::kFloat;
    if (type == ScalarType::kFloat64) return AttributeType::kDouble;
    return isSigned(type) ? AttributeType::kInt : AttributeType::kUint;
  }

  const std::vector<RowProperty>& properties_;
  std::vector<char> used_;
  PropertyPlan plan_;
};

}  // namespace

PropertyPlan planProperties(const std::vector<RowProperty>& properties) {
  return Planner(properties).plan();
}

}  // namespace stipple
