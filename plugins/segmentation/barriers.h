#pragma once

#include <vector>

#include "core/fem/assembly.h"
#include "plugins/segmentation/segmentation_options.h"
#include "plugins/segmentation/surface_graph.h"

namespace stipple {

/// The surface as labels see it: what flows where, and what they keep away from.
struct Terrain {
  Discretization discretization;
  SparseMatrix stiffness;  ///< L_A
  SurfaceGraph graph;
  Pieces pieces;
  std::vector<float> classifier;       ///< C of every site; empty unless an option needs it
  std::vector<std::uint8_t> atCrease;  ///< 1 for sites beside a blocked edge, or of a low classifier
  double noise = 0;                    ///< in mean spacings
  int k = 0;                           ///< neighbors used to find creases
};

Terrain buildTerrain(const PointSet& points, const SegmentationOptions& options, Progress& progress);

}  // namespace stipple
