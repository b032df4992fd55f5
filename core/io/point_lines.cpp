#include "core/io/point_lines.h"

#include <cmath>

#include "core/io/coordinates.h"

namespace stipple {

void PointLines::appendPosition(std::size_t row) {
  const Eigen::Vector3f& position = points_.positions()[row];
  const Eigen::Vector3d& origin = points_.origin();
  const bool single = points_.positionFileType() != ScalarType::kFloat64 && origin == Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) text_.append(separator_);
    if (single)
      text_.append(position[axis]);
    else
      text_.append(fileCoordinate(origin[axis], position[axis]));
  }
}

void PointLines::appendVector(const Eigen::Vector3f& vector) {
  for (const float component : vector) text_.append(separator_).append(component);
}

void PointLines::appendBytes(const Rgba8& color) {
  for (const std::uint8_t channel : {color.r, color.g, color.b})
    text_.append(separator_).append(std::uint32_t{channel});
}

void PointLines::appendFractions(const Rgba8& color) {
  constexpr float kDigits = 10000;  // four decimals tell 256 levels apart
  for (const std::uint8_t channel : {color.r, color.g, color.b}) {
    text_.append(separator_).append(std::round(static_cast<float>(channel) / 255 * kDigits) / kDigits);
  }
}

}  // namespace stipple
