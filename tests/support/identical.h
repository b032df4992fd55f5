#pragma once

#include <algorithm>

#include "core/points/point_set.h"

namespace stipple {

/// Same bits, names, file properties and order of everything that a point set has, apart from its identities.
inline bool identical(const PointSet& a, const PointSet& b) {
  const auto sameAttribute = [](const Attribute& left, const Attribute& right) {
    return left.name == right.name && left.file == right.file &&
           sameBits(left.column.values(), right.column.values());
  };
  return a.origin() == b.origin() && a.positionFileType() == b.positionFileType() &&
         sameBits(a.positionColumn().values(), b.positionColumn().values()) &&
         std::ranges::equal(a.attributes(), b.attributes(), sameAttribute) && a.triangles() == b.triangles();
}

}  // namespace stipple
