#include "render/appearance/splat_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/points/region.h"
#include "render/appearance/light.h"

namespace stipple {

namespace {

constexpr Rgba8 kPlain{204, 204, 204, 0};  // points without color
constexpr Rgba8 kNoDirection{128, 128, 128, 0};
constexpr std::size_t kGrain = 16384;

const Attribute& require(const PointSet& points, const std::string& name) {
  const Attribute* attribute = points.find(name);
  if (!attribute) throw InvalidInput(fmt::format("the points have no attribute '{}'", name));
  return *attribute;
}

// Calls with the values of a scalar attribute. Throws InvalidInput for vectors and colors.
template <class Call>
auto withScalars(const Attribute& attribute, Call&& call) {
  using Result = decltype(call(std::span<const float>()));
  return std::visit(
      [&]<class T>(const std::vector<T>& values) -> Result {
        if constexpr (std::is_arithmetic_v<T>) {
          return call(std::span<const T>(values));
        } else {
          throw InvalidInput(
              fmt::format("'{}' is a {}, expected numbers", attribute.name, nameOf(attribute.type())));
        }
      },
      attribute.column.values());
}

// Where a value lies in a range: 0 at its low end, 1 at its high end. Halves keep the longest ranges finite.
struct Scale {
  double low, inverseLength;
  explicit Scale(const std::pair<double, double>& range)
      : low(range.first / 2), inverseLength(1 / (range.second / 2 - range.first / 2)) {}
  double operator()(double value) const { return (value / 2 - low) * inverseLength; }
};

// Whole numbers that stand for kinds rather than for amounts.
template <std::integral T>
bool areLabels(const std::string& name, std::span<const T> values) {
  constexpr std::int64_t kLargest = 1 << 20;
  constexpr std::size_t kMostLabels = 4096;
  if (name == "segment" || name.starts_with("label")) return true;
  std::vector<bool> seen(2 * kLargest + 1);
  std::size_t labels = 0;
  for (const std::int64_t value : values) {
    if (value < -kLargest || value > kLargest) return false;
    if (seen[static_cast<std::size_t>(value + kLargest)]) continue;
    seen[static_cast<std::size_t>(value + kLargest)] = true;
    if (++labels > kMostLabels) return false;
  }
  return true;
}

// Applies color(i) to all points.
template <class Color>
std::vector<Rgba8> colorEach(std::size_t count, Color&& color) {
  std::vector<Rgba8> colors(count);
  parallelFor(count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      colors[i] = color(i);
      colors[i].a = 0;
    }
  });
  return colors;
}

template <class T>
std::vector<Rgba8> colorScalars(const PointSet& points, const ColorSource& source,
                                std::span<const T> values) {
  const Scale scale(source.range ? *source.range : rangeOf(points, source.attribute));
  const Colormap map = source.colormap.value_or(Colormap::kViridis);
  // So fine that steps of the table are below those of 8-bit colors.
  constexpr int kSteps = 4096;
  std::array<Rgba8, kSteps + 1> table;
  for (int i = 0; i <= kSteps; ++i) table[i] = mapColor(map, static_cast<double>(i) / kSteps);
  return colorEach(values.size(), [&](std::size_t i) {
    const double t = scale(static_cast<double>(values[i]));
    if (std::isnan(t)) return mapColor(map, t);
    return table[static_cast<std::size_t>(std::lround(std::clamp(t, 0.0, 1.0) * kSteps))];
  });
}

std::vector<Rgba8> colorNumbers(const PointSet& points, const ColorSource& source) {
  const Attribute& attribute = require(points, source.attribute);
  return withScalars(attribute, [&]<class T>(std::span<const T> values) {
    if constexpr (std::integral<T>) {
      if (!source.colormap && !source.range && areLabels(attribute.name, values)) {
        return colorEach(values.size(), [&](std::size_t i) { return labelColor(values[i]); });
      }
    }
    return colorScalars(points, source, values);
  });
}

Rgba8 directionColor(const Eigen::Vector3f& vector) {
  const Eigen::Vector3d direction = vector.cast<double>().stableNormalized();
  if (!direction.allFinite() || direction.isZero()) return kNoDirection;
  const Eigen::Vector3d scaled = 127.5 * (direction + Eigen::Vector3d::Ones());
  const auto channel = [&](int axis) { return static_cast<std::uint8_t>(std::lround(scaled[axis])); };
  return {channel(0), channel(1), channel(2), 0};
}

std::vector<Rgba8> baseColors(const PointSet& points, const ColorSource& source) {
  if (source.attribute.empty()) {
    const Attribute* color = points.find("color");
    if (!color || color->type() != AttributeType::kColor) return std::vector<Rgba8>(points.size(), kPlain);
    const auto values = color->column.view<Rgba8>();
    return colorEach(values.size(), [&](std::size_t i) { return values[i]; });
  }
  const Attribute& attribute = require(points, source.attribute);
  switch (attribute.type()) {
    case AttributeType::kColor: {
      const auto values = attribute.column.view<Rgba8>();
      return colorEach(values.size(), [&](std::size_t i) { return values[i]; });
    }
    case AttributeType::kVector3: {
      const auto values = attribute.column.view<Eigen::Vector3f>();
      return colorEach(values.size(), [&](std::size_t i) { return directionColor(values[i]); });
    }
    default:
      return colorNumbers(points, source);
  }
}

// Gray of the same luminance (Rec. 709) at saturation 0, the color itself at 1.
Rgba8 fade(const Rgba8& color, float saturation) {
  if (saturation >= 1) return color;
  const auto& linear = linearTable();
  const float r = linear[color.r], g = linear[color.g], b = linear[color.b];
  const float gray = 0.2126f * r + 0.7152f * g + 0.0722f * b;
  const auto channel = [&](float value) { return encodeSrgb(gray + saturation * (value - gray)); };
  return {channel(r), channel(g), channel(b), color.a};
}

void fadeColors(const PointSet& points, const std::string& attribute, std::vector<Rgba8>& colors) {
  const Scale scale(rangeOf(points, attribute));
  withScalars(require(points, attribute), [&](auto values) {
    parallelFor(colors.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const double t = scale(static_cast<double>(values[i]));
        colors[i] = fade(colors[i], std::isnan(t) ? 0 : static_cast<float>(std::clamp(t, 0.0, 1.0)));
      }
    });
  });
}

}  // namespace

std::pair<double, double> rangeOf(const PointSet& points, const std::string& attribute) {
  return withScalars(require(points, attribute), [](auto values) -> std::pair<double, double> {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto v : values) {
      const auto value = static_cast<double>(v);
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (low > high) return {0, 1};
    if (low < high) return {low, high};
    // A constant lies in the middle.
    const double half = std::max(0.5, 1e-6 * std::abs(low));
    return {low - half, high + half};
  });
}

std::vector<Rgba8> colorPoints(const PointSet& points, const ColorSource& source) {
  if (source.range && !(source.range->first < source.range->second)) {
    throw InvalidInput(
        fmt::format("the range of colors goes from {} to {}, expected a low and a higher value",
                    source.range->first, source.range->second));
  }
  std::vector<Rgba8> colors = baseColors(points, source);
  if (!source.saturationBy.empty()) fadeColors(points, source.saturationBy, colors);
  if (!source.selection.empty()) {
    const Region selected = regionWhereNotZero(points, source.selection);
    for (Index i = 0; i < points.size(); ++i) colors[i].a = selected.contains(i) ? 255 : 0;
  }
  return colors;
}

}  // namespace stipple
