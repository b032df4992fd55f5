#include "app/document/stroke_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "core/points/region.h"

namespace stipple {

namespace {

// How much of the value a dab lays down: one entry a point it reaches, 1 at the center, falling smoothly to
// 0.
struct Touch {
  Index point, site;
  double weight;
};

[[noreturn]] void refuseValue(const Stroke& stroke, std::string_view expected) {
  throw InvalidInput(fmt::format("the value [{}] cannot be painted on attribute '{}', expected {}",
                                 fmt::join(stroke.value, ", "), stroke.attribute, expected));
}

bool isWhole(double value) {
  return value == std::floor(value);
}

// The range of whole numbers that the column can be written with.
std::pair<double, double> wholeRange(ScalarType type, bool isSigned) {
  switch (type) {
    case ScalarType::kInt8:
      return {-128, 127};
    case ScalarType::kUint8:
      return {0, 255};
    case ScalarType::kInt16:
      return {-32768, 32767};
    case ScalarType::kUint16:
      return {0, 65535};
    default:
      break;
  }
  if (isSigned) return {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()};
  return {0, std::numeric_limits<std::uint32_t>::max()};
}

template <class T>
T readValue(const Stroke& stroke, ScalarType fileType) {
  const auto& value = stroke.value;
  if constexpr (std::is_same_v<T, Rgba8>) {
    const bool inRange =
        std::ranges::all_of(value, [](double v) { return isWhole(v) && v >= 0 && v <= 255; });
    if ((value.size() != 3 && value.size() != 4) || !inRange)
      refuseValue(stroke, "3 or 4 whole numbers from 0 to 255");
    const auto byte = [&](std::size_t c) { return static_cast<std::uint8_t>(value[c]); };
    return {byte(0), byte(1), byte(2), value.size() == 4 ? byte(3) : std::uint8_t{255}};
  } else if constexpr (std::is_same_v<T, Eigen::Vector3f>) {
    if (value.size() != 3) refuseValue(stroke, "3 numbers");
    return Eigen::Vector3d(value[0], value[1], value[2]).cast<float>();
  } else if constexpr (std::is_integral_v<T>) {
    const auto [low, high] = wholeRange(fileType, std::is_signed_v<T>);
    if (value.size() != 1 || !isWhole(value[0]) || value[0] < low || value[0] > high) {
      refuseValue(stroke, fmt::format("a whole number from {} to {}", low, high));
    }
    return static_cast<T>(value[0]);
  } else {
    if (value.size() != 1) refuseValue(stroke, "1 number");
    return static_cast<T>(value[0]);
  }
}

template <class T>
T erasedValue() {
  if constexpr (std::is_same_v<T, Rgba8>)
    return {255, 255, 255, 255};
  else if constexpr (std::is_same_v<T, Eigen::Vector3f>)
    return Eigen::Vector3f::Zero();
  else
    return T{0};
}

Rgba8 blend(const Rgba8& from, const Rgba8& to, double weight) {
  const auto mix = [&](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + weight * (double(b) - double(a))));
  };
  return {mix(from.r, to.r), mix(from.g, to.g), mix(from.b, to.b), mix(from.a, to.a)};
}

template <class T>
T blend(const T& from, const T& to, double weight) {
  if constexpr (std::is_integral_v<T>)
    return to;
  else if constexpr (std::is_same_v<T, double>)
    return from + weight * (to - from);
  else
    return from + static_cast<float>(weight) * (to - from);
}

AttributeValues newColumn(const Stroke& stroke, Index size) {
  if (stroke.value.size() == 3 || stroke.value.size() == 4)
    return std::vector<Rgba8>(size, Rgba8{255, 255, 255, 255});
  if (stroke.value.size() == 1 && isWhole(stroke.value[0])) return std::vector<std::int32_t>(size, 0);
  return std::vector<float>(size, 0.0f);
}

std::vector<Touch> findTouched(const SurfaceDistance& surface, const Eigen::Vector3f& place, double radius,
                               double strength) {
  std::vector<Touch> touched;
  const Index nearest = surface.findNearest(place);
  // The mirror image of a place may be far from the surface.
  if ((surface.sites().positions[nearest] - place).norm() > radius) return touched;
  for (const Reached& reached : surface.findWithin(nearest, static_cast<float>(radius))) {
    const double t = std::min(1.0, reached.distance / radius);
    const double weight = strength * (1 - t * t) * (1 - t * t);
    for (const Index point : surface.pointsOf(reached.site)) touched.push_back({point, reached.site, weight});
  }
  return touched;
}

void checkStroke(const PointSet& points, const Stroke& stroke) {
  if (!(stroke.radius > 0)) throw InvalidInput(fmt::format("the radius is {}, expected > 0", stroke.radius));
  if (!(stroke.strength > 0 && stroke.strength <= 1)) {
    throw InvalidInput(fmt::format("the strength is {}, expected in (0, 1]", stroke.strength));
  }
  if (!stroke.within.empty() && !points.has(stroke.within)) {
    throw InvalidInput(fmt::format("there is no attribute '{}' to paint within", stroke.within));
  }
  if (stroke.tool != StrokeTool::kPaint && !points.has(stroke.attribute)) {
    throw InvalidInput(
        fmt::format("there is no attribute '{}' to {}", stroke.attribute, nameOf(stroke.tool)));
  }
}

// The value that most neighbors and the point itself have. Between equals the point's own, then the least.
template <std::integral T>
T smoothed(const std::vector<T>& values, std::span<const Index> neighbors, T own) {
  std::vector<T> votes(neighbors.size() + 1, own);
  for (std::size_t n = 0; n < neighbors.size(); ++n) votes[n] = values[neighbors[n]];
  std::ranges::sort(votes);
  const auto countOf = [&](T value) { return std::ranges::count(votes, value); };
  T best = own;
  auto most = countOf(own);
  for (auto vote = votes.begin(); vote != votes.end(); vote = std::upper_bound(vote, votes.end(), *vote)) {
    if (countOf(*vote) > most) best = *vote, most = countOf(*vote);
  }
  return best;
}

// The mean over the neighbors that have a number.
template <std::floating_point T>
T smoothed(const std::vector<T>& values, std::span<const Index> neighbors, T own) {
  double sum = 0;
  int count = 0;
  for (const Index n : neighbors) {
    if (!std::isnan(values[n])) sum += values[n], ++count;
  }
  return count == 0 ? own : static_cast<T>(sum / count);
}

Eigen::Vector3f smoothed(const std::vector<Eigen::Vector3f>& values, std::span<const Index> neighbors,
                         const Eigen::Vector3f& own) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (const Index n : neighbors) {
    if (!values[n].hasNaN()) sum += values[n].cast<double>(), ++count;
  }
  return count == 0 ? own : Eigen::Vector3f((sum / count).cast<float>());
}

Rgba8 smoothed(const std::vector<Rgba8>& values, std::span<const Index> neighbors, const Rgba8& own) {
  if (neighbors.empty()) return own;
  Eigen::Array4d sum = Eigen::Array4d::Zero();
  for (const Index n : neighbors) {
    sum += Eigen::Array4d(values[n].r, values[n].g, values[n].b, values[n].a);
  }
  sum /= static_cast<double>(neighbors.size());
  const auto byte = [&](int c) { return static_cast<std::uint8_t>(std::lround(sum[c])); };
  return {byte(0), byte(1), byte(2), byte(3)};
}

// All values are taken before the first is changed, so that the order of the points does not matter.
template <class T>
void smooth(std::vector<T>& values, const SurfaceDistance& surface, std::span<const Touch> touched) {
  std::vector<T> fresh;
  fresh.reserve(touched.size());
  std::vector<Index> neighbors;
  for (const Touch& touch : touched) {
    neighbors.clear();
    for (const Index site : surface.neighborsOf(touch.site)) {
      neighbors.push_back(surface.sites().pointOfSite[site]);
    }
    fresh.push_back(smoothed(values, neighbors, values[touch.point]));
  }
  for (std::size_t t = 0; t < touched.size(); ++t) {
    T& value = values[touched[t].point];
    value = blend(value, fresh[t], touched[t].weight);
  }
}

// Not those outside of the region that the stroke is limited to, nor those that the filter holds back.
void keepPaintable(std::vector<Touch>& touched, const PointSet& points, const std::string& within,
                   const PointFilter& filter) {
  const Attribute* region = within.empty() ? nullptr : points.find(within);
  std::erase_if(touched, [&](const Touch& touch) {
    return (region && !isNotZero(region->column.values(), touch.point)) || (filter && !filter(touch.point));
  });
}

std::vector<Edit::Touched> touchedRows(const std::string& attribute, std::span<const Touch> touched) {
  if (touched.empty()) return {};
  std::vector<Index> rows;
  rows.reserve(touched.size());
  for (const Touch& touch : touched) rows.push_back(touch.point);
  std::ranges::sort(rows);
  return {{attribute, std::make_shared<const std::vector<Index>>(std::move(rows))}};
}

}  // namespace

bool prepareStroke(PointSet& points, const Stroke& stroke) {
  checkStroke(points, stroke);
  const bool isMissing = !points.has(stroke.attribute);
  Attribute made{.name = stroke.attribute, .column = {}, .file = {}};
  if (isMissing) made.column = Column(newColumn(stroke, points.size()));
  const Attribute& attribute = isMissing ? made : *points.find(stroke.attribute);
  if (stroke.tool == StrokeTool::kPaint) {
    std::visit(
        [&](const auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          readValue<T>(stroke, attribute.file.type);
        },
        attribute.column.values());
  }
  if (isMissing) points.set(stroke.attribute, made.column.values());
  return isMissing;
}

StrokePainter::StrokePainter(std::shared_ptr<const SurfaceDistance> surface, Stroke stroke)
    : surface_(std::move(surface)), stroke_(std::move(stroke)) {}

std::vector<Edit::Touched> StrokePainter::lay(PointSet& points, const Dab& dab,
                                              const PointFilter& filter) const {
  const bool isNew = prepareStroke(points, stroke_);
  std::vector<Touch> touched;
  if (points.size() > 0 && dab.pressure > 0) {
    const Eigen::Vector3f place = (dab.position - points.origin()).cast<float>();
    touched = findTouched(*surface_, place, stroke_.radius * dab.size, stroke_.strength * dab.pressure);
    keepPaintable(touched, points, stroke_.within, filter);
  }
  Attribute& attribute = *points.find(stroke_.attribute);
  if (!touched.empty()) {
    std::visit(
        [&](auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          if (stroke_.tool == StrokeTool::kSmooth) return smooth(values, *surface_, touched);
          const T value = stroke_.tool == StrokeTool::kErase ? erasedValue<T>()
                                                             : readValue<T>(stroke_, attribute.file.type);
          for (const Touch& touch : touched) {
            values[touch.point] = blend(values[touch.point], value, touch.weight);
          }
        },
        attribute.column.edit());
  }
  return isNew ? std::vector<Edit::Touched>{{stroke_.attribute, nullptr}}
               : touchedRows(stroke_.attribute, touched);
}

}  // namespace stipple
