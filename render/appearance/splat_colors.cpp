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

// Which points are colored: all of them, or some.
struct Chosen {
  std::size_t count;
  const Index* rows = nullptr;
  std::size_t operator[](std::size_t i) const { return rows ? rows[i] : i; }
};

// Applies color(row) to the chosen points.
template <class Color>
std::vector<Rgba8> colorEach(const Chosen& chosen, Color&& color) {
  std::vector<Rgba8> colors(chosen.count);
  parallelFor(chosen.count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      colors[i] = color(chosen[i]);
      colors[i].a = 0;
    }
  });
  return colors;
}

template <class T>
std::vector<Rgba8> colorScalars(std::span<const T> values, const Scale& scale, Colormap map,
                                const Chosen& chosen) {
  // So fine that steps of the table are below those of 8-bit colors.
  constexpr int kSteps = 4096;
  std::array<Rgba8, kSteps + 1> table;
  for (int i = 0; i <= kSteps; ++i) table[i] = mapColor(map, static_cast<double>(i) / kSteps);
  return colorEach(chosen, [&](std::size_t row) {
    const double t = scale(static_cast<double>(values[row]));
    if (std::isnan(t)) return mapColor(map, t);
    return table[static_cast<std::size_t>(std::lround(std::clamp(t, 0.0, 1.0) * kSteps))];
  });
}

std::vector<Rgba8> colorLabels(const Attribute& attribute, const Chosen& chosen) {
  return withScalars(attribute, [&](auto values) {
    return colorEach(chosen,
                     [&](std::size_t row) { return labelColor(static_cast<std::int64_t>(values[row])); });
  });
}

Rgba8 directionColor(const Eigen::Vector3f& vector) {
  const Eigen::Vector3d direction = vector.cast<double>().stableNormalized();
  if (!direction.allFinite() || direction.isZero()) return kNoDirection;
  const Eigen::Vector3d scaled = 127.5 * (direction + Eigen::Vector3d::Ones());
  const auto channel = [&](int axis) { return static_cast<std::uint8_t>(std::lround(scaled[axis])); };
  return {channel(0), channel(1), channel(2), 0};
}

std::vector<Rgba8> colorVectors(const Attribute& attribute, const Chosen& chosen) {
  const auto values = attribute.column.view<Eigen::Vector3f>();
  return colorEach(chosen, [&](std::size_t row) { return directionColor(values[row]); });
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

void fadeColors(const Attribute& attribute, const Scale& scale, const Chosen& chosen,
                std::vector<Rgba8>& colors) {
  withScalars(attribute, [&](auto values) {
    parallelFor(colors.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const double t = scale(static_cast<double>(values[chosen[i]]));
        colors[i] = fade(colors[i], std::isnan(t) ? 0 : static_cast<float>(std::clamp(t, 0.0, 1.0)));
      }
    });
  });
}

PointColors::Kind kindOf(const PointSet& points, const ColorSource& source) {
  using Kind = PointColors::Kind;
  if (source.attribute.empty()) {
    const Attribute* color = points.find("color");
    return color && color->type() == AttributeType::kColor ? Kind::kColors : Kind::kPlain;
  }
  const Attribute& attribute = require(points, source.attribute);
  if (attribute.type() == AttributeType::kColor) return Kind::kColors;
  if (attribute.type() == AttributeType::kVector3) return Kind::kDirections;
  const bool areKinds = withScalars(attribute, [&]<class T>(std::span<const T> values) {
    if constexpr (std::integral<T>)
      return !source.colormap && !source.range && areLabels(attribute.name, values);
    else
      return false;
  });
  return areKinds ? Kind::kLabels : Kind::kNumbers;
}

std::vector<Rgba8> colorChosen(const PointSet& points, const PointColors& colors, const Chosen& chosen) {
  using Kind = PointColors::Kind;
  if (colors.kind() == Kind::kPlain) return std::vector<Rgba8>(chosen.count, kPlain);
  const std::string& name = colors.source().attribute;
  const Attribute& attribute = require(points, name.empty() ? "color" : name);
  switch (colors.kind()) {
    case Kind::kDirections:
      return colorVectors(attribute, chosen);
    case Kind::kLabels:
      return colorLabels(attribute, chosen);
    case Kind::kNumbers:
      return withScalars(attribute, [&](auto values) {
        return colorScalars(values, Scale(colors.range()), colors.colormap(), chosen);
      });
    default:
      break;
  }
  const std::span<const Rgba8> values = points.values<Rgba8>(attribute.name);
  return colorEach(chosen, [&](std::size_t row) { return values[row]; });
}

bool isNotZero(double value) {
  return value != 0 && !std::isnan(value);
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

PointColors::PointColors(const PointSet& points, ColorSource source)
    : source_(std::move(source)), kind_(kindOf(points, source_)) {
  if (source_.range && !(source_.range->first < source_.range->second)) {
    throw InvalidInput(
        fmt::format("the range of colors goes from {} to {}, expected a low and a higher value",
                    source_.range->first, source_.range->second));
  }
  if (kind_ == Kind::kNumbers) range_ = source_.range ? *source_.range : rangeOf(points, source_.attribute);
  if (!source_.saturationBy.empty()) saturationRange_ = rangeOf(points, source_.saturationBy);
  if (!source_.selection.empty()) require(points, source_.selection);
}

std::vector<Rgba8> PointColors::of(const PointSet& points) const {
  const Chosen all{.count = points.size()};
  std::vector<Rgba8> colors = colorChosen(points, *this, all);
  if (!source_.saturationBy.empty())
    fadeColors(require(points, source_.saturationBy), Scale(saturationRange_), all, colors);
  if (!source_.selection.empty()) {
    const Region selected = regionWhereNotZero(points, source_.selection);
    for (Index i = 0; i < points.size(); ++i) colors[i].a = selected.contains(i) ? 255 : 0;
  }
  return colors;
}

std::vector<Rgba8> PointColors::of(const PointSet& points, std::span<const Index> rows) const {
  const Chosen chosen{.count = rows.size(), .rows = rows.data()};
  std::vector<Rgba8> colors = colorChosen(points, *this, chosen);
  if (!source_.saturationBy.empty())
    fadeColors(require(points, source_.saturationBy), Scale(saturationRange_), chosen, colors);
  if (!source_.selection.empty()) {
    withScalars(require(points, source_.selection), [&](auto values) {
      for (std::size_t i = 0; i < rows.size(); ++i)
        colors[i].a = isNotZero(static_cast<double>(values[rows[i]])) ? 255 : 0;
    });
  }
  return colors;
}

std::vector<Rgba8> colorPoints(const PointSet& points, const ColorSource& source) {
  return PointColors(points, source).of(points);
}

}  // namespace stipple
