#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "plugins/editing/editing.h"

namespace stipple {

namespace {

struct Box {
  Eigen::Array3d low, high;
  bool contains(const Eigen::Vector3d& p) const {
    return (p.array() >= low).all() && (p.array() <= high).all();
  }
};

// "x0,y0,z0,x1,y1,z1"; nothing where the text is empty.
std::optional<Box> parseBox(const std::string& text) {
  if (text.empty()) return {};
  const auto refuse = [&]() -> Box {
    throw InvalidInput(fmt::format("box is \"{}\", expected six numbers x0,y0,z0,x1,y1,z1", text));
  };
  std::array<double, 6> numbers{};
  const char *at = text.data(), *end = text.data() + text.size();
  for (std::size_t i = 0; i < 6; ++i) {
    while (at != end && *at == ' ') ++at;
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc() || !std::isfinite(numbers[i])) return refuse();
    at = next;
    while (at != end && *at == ' ') ++at;
    if (i < 5 && (at == end || *at++ != ',')) return refuse();
  }
  if (at != end) return refuse();
  const Eigen::Array3d a(numbers[0], numbers[1], numbers[2]), b(numbers[3], numbers[4], numbers[5]);
  return Box{a.min(b), a.max(b)};
}

RunResult deletePoints(const OneShotInput& input, Progress&, Report& report) {
  return withoutRows(input.points, input.region.rows(input.points.size()), report);
}

RunResult crop(const OneShotInput& input, Progress&, Report& report) {
  const std::optional<Box> box = parseBox(input.parameters.text("box"));
  if (!box && input.region.isEverything())
    throw InvalidInput("there is nothing to crop to: give a box, or a region");
  const bool inverts = input.parameters.boolean("invert");
  const PointSet& points = input.points;
  std::vector<Index> rows;
  for (Index row = 0; row < points.size(); ++row) {
    const Eigen::Vector3d place = points.origin() + points.positions()[row].cast<double>();
    const bool isInside = input.region.contains(row) && (!box || box->contains(place));
    if (isInside == inverts) rows.push_back(row);
  }
  return withoutRows(points, std::move(rows), report);
}

}  // namespace

RunResult withoutRows(const PointSet& points, std::vector<Index> rows, Report& report) {
  if (rows.size() == points.size()) throw InvalidInput("this would remove all points");
  RunResult result{.points = points, .removedRows = std::move(rows)};
  if (!result.removedRows.empty()) result.points.removeRows(result.removedRows);
  report.values.push_back({"removed", static_cast<std::int64_t>(result.removedRows.size())});
  return result;
}

std::unique_ptr<Operator> makeDeletePoints() {
  return makeOneShot({.id = "delete_points",
                      .title = "Delete points",
                      .help = "Removes the points of the region; triangles that lose a corner go, too.",
                      .region = RegionUse::kMask,
                      .writes = {"position", "triangles"}},
                     deletePoints);
}

std::unique_ptr<Operator> makeCrop() {
  return makeOneShot(
      {.id = "crop",
       .title = "Crop",
       .help = "Keeps the points that lie in the box, and in the region where there is one.",
       .region = RegionUse::kLimits,
       .parameters = {{.id = "box",
                       .title = "Box",
                       .type = ParameterType::kText,
                       .defaultValue = "",
                       .help = "Two opposite corners in the coordinates of the file: x0,y0,z0,x1,y1,z1."},
                      {.id = "invert",
                       .title = "Invert",
                       .type = ParameterType::kBool,
                       .defaultValue = false,
                       .help = "Keep what lies outside."}},
       .writes = {"position", "triangles"}},
      crop);
}

}  // namespace stipple
