#include "core/points/field.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>

namespace stipple {

namespace {

// IEC 61966-2-1.
double decode(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

double encode(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

template <class T>
T roundTo(double value) {
  constexpr double kLeast = std::numeric_limits<T>::lowest(), kMost = std::numeric_limits<T>::max();
  return static_cast<T>(std::clamp(std::is_integral_v<T> ? std::round(value) : value, kLeast, kMost));
}

void store(const Eigen::RowVectorXd& value, Rgba8& target) {
  target.r = srgbOf(value[0]);
  target.g = srgbOf(value[1]);
  target.b = srgbOf(value[2]);
}

void store(const Eigen::RowVectorXd& value, Eigen::Vector3f& target) {
  for (int c = 0; c < 3; ++c) target[c] = roundTo<float>(value[c]);
}

template <class T>
void store(const Eigen::RowVectorXd& value, T& target) {
  target = roundTo<T>(value[0]);
}

Eigen::RowVector3d load(const Rgba8& color) {
  return {linearLightOf(color.r), linearLightOf(color.g), linearLightOf(color.b)};
}

Eigen::RowVector3d load(const Eigen::Vector3f& vector) {
  return vector.transpose().cast<double>();
}

template <class T>
Eigen::Matrix<double, 1, 1> load(const T& number) {
  return Eigen::Matrix<double, 1, 1>(static_cast<double>(number));
}

}  // namespace

double linearLightOf(std::uint8_t srgb) {
  static const std::array<double, 256> kLinear = [] {
    std::array<double, 256> table{};
    for (std::size_t s = 0; s < table.size(); ++s) table[s] = decode(static_cast<double>(s) / 255);
    return table;
  }();
  return kLinear[srgb];
}

std::uint8_t srgbOf(double linearLight) {
  if (!(linearLight > 0)) return 0;
  return static_cast<std::uint8_t>(std::lround(255 * encode(std::min(linearLight, 1.0))));
}

int channelsOf(AttributeType type) {
  return type == AttributeType::kColor || type == AttributeType::kVector3 ? 3 : 1;
}

Eigen::MatrixXd readField(const Attribute& attribute, std::span<const Index> rows) {
  Eigen::MatrixXd field(rows.size(), channelsOf(attribute.type()));
  std::visit(
      [&](const auto& values) {
        for (std::size_t r = 0; r < rows.size(); ++r)
          field.row(static_cast<Eigen::Index>(r)) = load(values[rows[r]]);
      },
      attribute.column.values());
  return field;
}

void writeField(Attribute& attribute, std::span<const Index> rows,
                const Eigen::Ref<const Eigen::MatrixXd>& values) {
  assert(values.rows() == std::ssize(rows) && values.cols() == channelsOf(attribute.type()));
  if (rows.empty()) return;
  std::visit(
      [&](auto& column) {
        for (std::size_t r = 0; r < rows.size(); ++r) {
          const Eigen::RowVectorXd value = values.row(static_cast<Eigen::Index>(r));
          if (value.allFinite()) store(value, column[rows[r]]);
        }
      },
      attribute.column.edit());
}

}  // namespace stipple
