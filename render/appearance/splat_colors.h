#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/points/point_set.h"
#include "render/appearance/colormap.h"

namespace stipple {

/// Where the colors of points come from.
struct ColorSource {
  std::string attribute = {};  ///< empty: `color` where there is one, else light gray
  /// Empty, or a scalar that fades colors to gray where it is low (the paper's Fig. 3).
  std::string saturationBy = {};
  std::optional<Colormap> colormap = {};                ///< none: viridis, or the palette of labels
  std::optional<std::pair<double, double>> range = {};  ///< of the colormap; none: see rangeOf
  std::string selection = {};  ///< empty, or an attribute: points where it is not 0 are shown selected
};

/// Smallest and largest finite value of a scalar attribute; {0, 1} where no value is finite, never of zero
/// length. Throws InvalidInput where the attribute is missing or no scalar.
std::pair<double, double> rangeOf(const PointSet& points, const std::string& attribute);

/// What a source makes of a point set, with everything that depends on all values settled, so that rows that
/// change later are colored alike. Colors have alpha 0 (255 where selected). A color attribute as it is;
/// integer attributes named `segment` or `label...`, or with at most 4096 distinct values of which none
/// exceeds 2^20, through the palette of labels (0: gray) unless a colormap or a range is given; other scalars
/// through the colormap, NaN gray; a vector3 as red, green, blue of its direction.
class PointColors {
 public:
  enum class Kind { kPlain, kColors, kDirections, kLabels, kNumbers };

  /// Plain gray.
  PointColors() = default;
  /// Throws InvalidInput where an attribute is missing or cannot be shown.
  PointColors(const PointSet& points, ColorSource source);

  const ColorSource& source() const { return source_; }
  Kind kind() const { return kind_; }
  /// Of the colormap, where numbers are shown.
  std::pair<double, double> range() const { return range_; }
  Colormap colormap() const { return source_.colormap.value_or(Colormap::kViridis); }

  /// Of all points, or of some rows. Throws InvalidInput where an attribute is no longer there.
  std::vector<Rgba8> of(const PointSet& points) const;
  std::vector<Rgba8> of(const PointSet& points, std::span<const Index> rows) const;

 private:
  ColorSource source_;
  Kind kind_ = Kind::kPlain;
  std::pair<double, double> range_{0, 1}, saturationRange_{0, 1};
};

/// Of all points, at once.
std::vector<Rgba8> colorPoints(const PointSet& points, const ColorSource& source);

}  // namespace stipple
