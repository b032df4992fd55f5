#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// What a format can hold beside positions.
struct FormatMeans {
  std::initializer_list<std::string_view> attributes;
  bool triangles = false;
  bool alpha = false;
};

/// The attribute where it is there and of that type, else null.
const Attribute* findOfType(const PointSet& points, std::string_view name, AttributeType type);

/// One sentence for each thing of the point set that a format with these means loses.
std::vector<std::string> lossesOf(const PointSet& points, const FormatMeans& means);

}  // namespace stipple
