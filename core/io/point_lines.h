#pragma once

#include "core/io/text_buffer.h"
#include "core/points/point_set.h"

namespace stipple {

/// Writes the numbers of single points as text, each with a separator before it.
class PointLines {
 public:
  PointLines(const PointSet& points, TextBuffer& text, char separator = ' ')
      : points_(points), text_(text), separator_(separator) {}

  /// Coordinates of the file, as float where the point set has no origin and floats came in. The first number
  /// has no separator before it.
  void appendPosition(std::size_t row);
  void appendVector(const Eigen::Vector3f& vector);
  /// Red, green, blue as 0 to 255.
  void appendBytes(const Rgba8& color);
  /// Red, green, blue as 0 to 1, with the digits that give the same bytes again.
  void appendFractions(const Rgba8& color);

 private:
  const PointSet& points_;
  TextBuffer& text_;
  char separator_;
};

}  // namespace stipple
