#include "app/document/stroke.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <type_traits>

#include "app/document/surface_distance.h"

namespace stipple {

namespace {

// How much of the value a dab lays down: one entry a point it reaches, 1 at the center, falling smoothly to
// 0.
struct Touch {
  Index point;
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

// All file rows of each site, in compressed rows.
struct Copies {
  std::vector<Index> offsets, points;

  explicit Copies(const Sites& sites) : offsets(sites.size() + 1, 0), points(sites.siteOfPoint.size()) {
    for (const Index site : sites.siteOfPoint) ++offsets[site + 1];
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    std::vector<Index> next(offsets.begin(), offsets.end() - 1);
    for (Index p = 0; p < points.size(); ++p) points[next[sites.siteOfPoint[p]]++] = p;
  }
  std::span<const Index> of(Index site) const {
    return std::span(points).subspan(offsets[site], offsets[site + 1] - offsets[site]);
  }
};

std::vector<Touch> findTouched(const SurfaceDistance& surface, const Copies& copies,
                               const Eigen::Vector3f& place, double radius, double strength) {
  std::vector<Touch> touched;
  for (const Reached& reached : surface.findWithin(surface.findNearest(place), static_cast<float>(radius))) {
    const double t = std::min(1.0, reached.distance / radius);
    const double weight = strength * (1 - t * t) * (1 - t * t);
    for (const Index point : copies.of(reached.site)) touched.push_back({point, weight});
  }
  return touched;
}

void checkStroke(const Stroke& stroke) {
  if (!(stroke.radius > 0)) throw InvalidInput(fmt::format("the radius is {}, expected > 0", stroke.radius));
  if (!(stroke.strength > 0 && stroke.strength <= 1)) {
    throw InvalidInput(fmt::format("the strength is {}, expected in (0, 1]", stroke.strength));
  }
}

}  // namespace

PointSet applyStroke(const PointSet& points, const Stroke& stroke, Progress& progress) {
  checkStroke(stroke);
  PointSet painted = points;
  if (!painted.has(stroke.attribute)) {
    if (stroke.tool == StrokeTool::kErase) {
      throw InvalidInput(fmt::format("there is no attribute '{}' to erase", stroke.attribute));
    }
    painted.set(stroke.attribute, newColumn(stroke, points.size()));
  }
  Attribute& attribute = *painted.find(stroke.attribute);
  const ScalarType fileType = attribute.file.type;
  std::visit(
      [&](auto& values) {
        using T = typename std::decay_t<decltype(values)>::value_type;
        const T value = stroke.tool == StrokeTool::kErase ? erasedValue<T>() : readValue<T>(stroke, fileType);
        if (points.size() == 0 || stroke.dabs.empty()) return;
        const SurfaceDistance surface(points, &progress);
        const Copies copies(surface.sites());
        for (std::size_t d = 0; d < stroke.dabs.size(); ++d) {
          progress.throwIfCancelled();
          progress.report(static_cast<double>(d) / static_cast<double>(stroke.dabs.size()), "painting");
          const Dab& dab = stroke.dabs[d];
          if (dab.pressure <= 0) continue;
          const Eigen::Vector3f place = (dab.position - points.origin()).cast<float>();
          const double strength = stroke.strength * dab.pressure;
          for (const Touch& touch : findTouched(surface, copies, place, stroke.radius, strength)) {
            values[touch.point] = blend(values[touch.point], value, touch.weight);
          }
        }
      },
      attribute.column.edit());
  return painted;
}

}  // namespace stipple
