#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/points/attribute.h"

namespace stipple {

/// One number in every row of a file: its name, its type and where it stands in the row.
struct RowProperty {
  std::string name;
  ScalarType type = ScalarType::kFloat32;
  std::size_t offset = 0;  ///< bytes from the begin of the row
};

/// How the numbers of a color become bytes.
enum class ColorCoding {
  kBytes,    ///< 0 to 255 in one byte
  kNumbers,  ///< wider integers or reals: the largest value tells whether the range is 1, 255 or 65535
  kSphericalHarmonics,  ///< coefficients of order 0 of a Gaussian splat
};

/// An attribute and the properties that its values come from, in order of components.
struct PlannedAttribute {
  std::string name;
  AttributeType type = AttributeType::kFloat;
  std::vector<std::size_t> sources;
  FileProperty file;
  ColorCoding coding = ColorCoding::kBytes;
};

struct PropertyPlan {
  std::array<std::size_t, 3> position{};
  std::vector<PlannedAttribute> attributes;
  std::vector<std::string> warnings;
};

/// Decides what the named properties of a file mean: coordinates, normal, color, vectors of three, single
/// numbers (names as in docs: scalar_ is stripped unless the plain name is taken). Throws InvalidInput where
/// x, y or z lacks, or for more than 4096 properties.
PropertyPlan planProperties(const std::vector<RowProperty>& properties);

}  // namespace stipple
