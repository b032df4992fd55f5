#include "core/io/text_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

namespace stipple {

std::string canonicalColumnName(const std::string& word) {
  std::string lower = word;
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kNames = {
      {{"r", "red"},
       {"g", "green"},
       {"b", "blue"},
       {"a", "alpha"},
       {"rf", "red"},
       {"gf", "green"},
       {"bf", "blue"},
       {"normal_x", "nx"},
       {"normal_y", "ny"},
       {"normal_z", "nz"},
       {"normalx", "nx"},
       {"normaly", "ny"},
       {"normalz", "nz"},
       {"i", "intensity"}}};
  for (const auto& [theirs, ours] : kNames) {
    if (lower == theirs) return std::string(ours);
  }
  static constexpr std::array<std::string_view, 10> kKept = {"x",  "y",   "z",     "nx",   "ny",
                                                             "nz", "red", "green", "blue", "alpha"};
  return std::ranges::find(kKept, lower) != kKept.end() ? lower : word;
}

namespace {

bool isColorName(std::string_view name) {
  return name == "red" || name == "green" || name == "blue" || name == "alpha";
}

class Columns {
 public:
  Columns(const NumberTable& table, std::string_view extension) : table_(table), extension_(extension) {}

  std::vector<RowProperty> named(const std::vector<std::string>& names) {
    for (std::size_t c = 0; c < names.size(); ++c) {
      const bool byte = isColorName(names[c]) && table_.areBytes(c, 1);
      properties_.push_back({.name = names[c], .type = byte ? ScalarType::kUint8 : realTypeOf(table_, c)});
    }
    return unifyColors();
  }

  std::vector<RowProperty> guessed() {
    add({"x", "y", "z"}, ScalarType::kFloat64);
    bool hasNormal = false, hasColor = false;
    while (next() < table_.columns) {
      const std::size_t rest = table_.columns - next();
      // One number and then triples: the number is the intensity when colors follow.
      const bool scalarFirst = rest % 3 == 1 && rest >= 4 && !hasColor && table_.areBytes(next() + 1, 3);
      if (rest >= 3 && !scalarFirst && !hasNormal && areUnit(next())) {
        add({"nx", "ny", "nz"}, ScalarType::kFloat32);
        hasNormal = true;
      } else if (rest >= 3 && !scalarFirst && !hasColor && areColors(next())) {
        add({"red", "green", "blue"}, table_.areBytes(next(), 3) ? ScalarType::kUint8 : ScalarType::kFloat32);
        hasColor = true;
      } else if (table_.columns == 6 && rest == 3) {
        add({"nx", "ny", "nz"}, ScalarType::kFloat32);  // vectors that are not of unit length
      } else {
        addScalar(scalarFirst);
      }
    }
    return std::move(properties_);
  }

 private:
  std::size_t next() const { return properties_.size(); }

  void add(std::initializer_list<const char*> names, ScalarType type) {
    for (const char* name : names) properties_.push_back({.name = name, .type = type});
  }

  void addScalar(bool beforeColors) {
    const bool leica = extension_ == ".pts" || extension_ == ".ptx";
    std::string name = fmt::format("column_{}", next() + 1);
    if (beforeColors || (leica && next() == 3))
      name = "intensity";
    else if (table_.columns == 4)
      name = "scalar";
    properties_.push_back({.name = "scalar_" + name, .type = realTypeOf(table_, next())});
  }

  // Nearly all vectors have the length 1, but for the digits that were written.
  bool areUnit(std::size_t first) const {
    constexpr double kTolerance = 0.02, kShare = 0.95;
    std::size_t unit = 0;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const double length =
          std::hypot(table_.at(row, first), table_.at(row, first + 1), table_.at(row, first + 2));
      if (std::abs(length - 1) <= kTolerance) ++unit;
    }
    return static_cast<double>(unit) >= kShare * static_cast<double>(table_.rows());
  }

  bool areColors(std::size_t first) const {
    if (table_.areBytes(first, 3)) return true;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      for (std::size_t column = first; column < first + 3; ++column) {
        if (!(table_.at(row, column) >= 0 && table_.at(row, column) <= 1)) return false;
      }
    }
    return table_.columns % 3 == 0;
  }

  // One channel that is no byte makes none of them bytes.
  std::vector<RowProperty> unifyColors() {
    const auto isReal = [](const RowProperty& property) {
      return isColorName(property.name) && property.type != ScalarType::kUint8;
    };
    if (std::ranges::any_of(properties_, isReal)) {
      for (RowProperty& property : properties_) {
        if (isColorName(property.name)) property.type = ScalarType::kFloat32;
      }
    }
    return std::move(properties_);
  }

  const NumberTable& table_;
  std::string_view extension_;
  std::vector<RowProperty> properties_;
};

}  // namespace

std::vector<RowProperty> nameColumns(const NumberTable& table, const std::vector<std::string>& headerWords,
                                     std::string_view extension) {
  std::vector<std::string> names;
  for (const std::string& word : headerWords) names.push_back(canonicalColumnName(word));
  const auto has = [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); };
  Columns columns(table, extension);
  return names.size() == table.columns && has("x") && has("y") && has("z") ? columns.named(names)
                                                                           : columns.guessed();
}

}  // namespace stipple
