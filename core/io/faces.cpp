#include "core/io/faces.h"

#include <algorithm>

namespace stipple {

bool appendPolygon(std::span<const std::int64_t> corners, Index pointCount,
                   std::vector<Triangle>& triangles) {
  for (const std::int64_t corner : corners) {
    if (corner < 0 || corner >= pointCount) return false;
  }
  for (std::size_t c = 2; c < corners.size(); ++c) {
    triangles.push_back(
        {static_cast<Index>(corners[0]), static_cast<Index>(corners[c - 1]), static_cast<Index>(corners[c])});
  }
  return true;
}

bool appendStrips(std::span<const std::int64_t> corners, Index pointCount, std::vector<Triangle>& triangles) {
  bool complete = true;
  std::size_t begin = 0;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (corners[c] < 0) {
      begin = c + 1;
      continue;
    }
    if (corners[c] >= pointCount) {
      complete = false;
      begin = c + 1;
      continue;
    }
    if (c < begin + 2) continue;
    Triangle triangle{static_cast<Index>(corners[c - 2]), static_cast<Index>(corners[c - 1]),
                      static_cast<Index>(corners[c])};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[0] == triangle[2]) continue;
    if ((c - begin) % 2 == 1) std::swap(triangle[0], triangle[1]);
    triangles.push_back(triangle);
  }
  return complete;
}

}  // namespace stipple
