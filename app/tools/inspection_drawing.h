#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "app/tools/inspect.h"

namespace stipple {

/// A line to be drawn over the picture.
struct ColoredSegment {
  glm::vec3 from{}, to{};  ///< world
  Rgba8 color;
};

inline constexpr Rgba8 kNeighborColor{150, 150, 150, 255}, kFanColor{255, 190, 40, 255},
    kForeignColumnColor{200, 110, 255, 255}, kMajorAxisColor{235, 70, 60, 255},
    kMinorAxisColor{80, 200, 80, 255}, kNormalColor{70, 140, 255, 255};

/// The paper's Fig. 2: lines to the neighbors, the triangles of the fan, lines to columns of the matrix that
/// only other fans bring in, and the frame from the barycenter: axes of 2 sqrt(eigenvalue), as far as an
/// even disc reaches; the normal as long as the minor axis. What comes later is to be drawn over the rest.
std::vector<ColoredSegment> segmentsOf(const PointInspection& inspection, const PointSet& points);

/// The numbers, a few lines of text.
std::vector<std::string> linesOf(const PointInspection& inspection);

}  // namespace stipple
