#pragma once

#include <Eigen/Core>
#include <span>

#include "core/points/point_set.h"

namespace stipple {

/// Linear light in [0, 1] of an 8-bit sRGB value, and back: rounded, clamped, NaN is 0.
double linearLightOf(std::uint8_t srgb);
std::uint8_t srgbOf(double linearLight);

/// Numbers that may be averaged for each value of an attribute: 3 for colors and vectors, else 1.
int channelsOf(AttributeType type);

/// The attribute at `rows` as rows x channels. Colors are linear light, without alpha. NaN and infinity come
/// along.
Eigen::MatrixXd readField(const Attribute& attribute, std::span<const Index> rows);

/// Writes what readField reads, at `rows` only. Numbers are rounded and clamped to what the type holds, alpha
/// stays. Rows of `values` that are not finite are left out.
void writeField(Attribute& attribute, std::span<const Index> rows,
                const Eigen::Ref<const Eigen::MatrixXd>& values);

}  // namespace stipple
