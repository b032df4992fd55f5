#include <fmt/format.h>

#include <algorithm>

#include "core/geometry/nearest_points.h"
#include "core/io/point_io.h"
#include "plugins/editing/editing.h"

namespace stipple {

namespace {

// Names between commas; empty: all.
std::vector<std::string> namesIn(const std::string& text, const PointSet& source) {
  std::vector<std::string> names;
  std::string name;
  for (const char c : text + ",") {
    if (c == ' ' && name.empty()) continue;
    if (c != ',') {
      name += c;
      continue;
    }
    while (name.ends_with(' ')) name.pop_back();
    if (!name.empty()) names.push_back(name);
    name.clear();
  }
  if (names.empty()) {
    for (const Attribute& attribute : source.attributes()) names.push_back(attribute.name);
  }
  return names;
}

// The attribute of the target, or a new one like that of the source.
Attribute& targetOf(PointSet& points, const Attribute& from) {
  if (!points.has(from.name)) {
    Attribute made = from;
    std::visit(
        [&](const auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          if constexpr (std::is_same_v<T, Rgba8>)
            made.column = Column(std::vector<T>(points.size(), Rgba8{255, 255, 255, 255}));
          else if constexpr (std::is_same_v<T, Eigen::Vector3f>)
            made.column = Column(std::vector<T>(points.size(), Eigen::Vector3f::Zero()));
          else
            made.column = Column(std::vector<T>(points.size(), T{0}));
        },
        from.column.values());
    points.insert(std::move(made));
  }
  Attribute& found = *points.find(from.name);
  if (found.type() != from.type())
    throw InvalidInput(fmt::format("the attribute \"{}\" has another type in the other scan", from.name));
  return found;
}

RunResult transfer(const OneShotInput& input, Progress& progress, Report& report) {
  const std::string& path = input.parameters.text("from");
  if (path.empty()) throw InvalidInput("give the file that attributes are taken from");
  PartialProgress reading(progress, 0, 0.3);
  const PointSet source = readPoints(path, reading).points;
  progress.report(0.3, "finding nearest points");
  // Differences of the two origins are taken in double.
  const Eigen::Vector3d shift = input.points.origin() - source.origin();
  std::vector<Eigen::Vector3f> places;
  places.reserve(input.points.size());
  for (const Eigen::Vector3f& p : input.points.positions())
    places.push_back((p.cast<double>() + shift).cast<float>());
  const std::vector<Index> nearest = findNearestPoints(source.positions(), places, &progress);
  const double most = input.parameters.number("max_distance");
  std::vector<Index> rows;
  for (Index row = 0; row < input.points.size(); ++row) {
    const double distance = (source.positions()[nearest[row]] - places[row]).cast<double>().norm();
    if (input.region.contains(row) && (most == 0 || distance <= most)) rows.push_back(row);
  }
  progress.report(0.9, "copying attributes");
  RunResult result{.points = input.points};
  for (const std::string& name : namesIn(input.parameters.text("attributes"), source)) {
    const Attribute* from = source.find(name);
    if (!from) throw InvalidInput(fmt::format("{}: there is no attribute \"{}\"", path, name));
    Attribute& to = targetOf(result.points, *from);
    std::visit(
        [&](auto& values) {
          using Values = std::decay_t<decltype(values)>;
          const auto& taken = std::get<Values>(from->column.values());
          for (const Index row : rows) values[row] = taken[nearest[row]];
        },
        to.column.edit());
  }
  report.values = {{"points", static_cast<std::int64_t>(rows.size())}};
  return result;
}

}  // namespace

std::unique_ptr<Operator> makeTransferAttributes() {
  return makeOneShot(
      {.id = "transfer_attributes",
       .title = "Transfer attributes",
       .help = "Each point takes over the attributes of the nearest point of another scan, bit for bit.",
       .region = RegionUse::kLimits,
       .parameters = {{.id = "from",
                       .title = "From",
                       .type = ParameterType::kText,
                       .defaultValue = "",
                       .help = "The file of the other scan."},
                      {.id = "attributes",
                       .title = "Attributes",
                       .type = ParameterType::kText,
                       .defaultValue = "",
                       .help = "Names between commas; empty: all of them."},
                      {.id = "max_distance",
                       .title = "Largest distance",
                       .unit = Unit::kLength,
                       .defaultValue = 0.0,
                       .min = 0,
                       .help = "Points that have none so near keep what they have; 0: any distance."}},
       .writes = {"color", "normal"}},
      transfer);
}

}  // namespace stipple
