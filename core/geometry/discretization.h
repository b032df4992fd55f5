#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/fans.h"
#include "core/geometry/sites.h"
#include "core/progress.h"

namespace stipple {

/// How stiffness and mass come from fans. voronoi: lengths of Voronoi edges, an M-matrix (scalar A). element: average of
/// the elements of all fans (tensor A). paper: Eq. (8)-(11). mesh: cotangents of the triangles of the file.
enum class Scheme { kVoronoi, kElement, kPaper, kMesh };
struct DiscretizationOptions {
  Scheme scheme = Scheme::kVoronoi;
  Metric metric = Metric::kUnfolded;
  bool consensus = true;  ///< vote the fans into one conforming triangulation where they can agree (not for paper, mesh)
  int k = 0;              ///< neighbors that a fan starts with; 0: 24, or 60 for scheme paper
  double minAngle = 0;    ///< radians; drops neighbors of thin triangles; at most 10 degrees, 25 for scheme paper
};

/// Wall clock and processor seconds of one stage.
struct StageTime {
  double seconds = 0, cpuSeconds = 0;
};

struct DiscretizationTimes {
  StageTime order, neighbors, frames, fans, consensus, assembly;
};

/// A point set made ready for finite elements: sites, one tangent frame and one fan each. All rows are sites.
struct Discretization {
  DiscretizationOptions options;
  Sites sites;
  std::vector<Eigen::Vector3f> normals;  ///< m x 3, unit, sign arbitrary
  /// Scheme mesh: one-rings of the triangles, ascending, each with kGapAfter.
  Fans fans;
  std::vector<std::uint8_t> resolved;    ///< m: the fan consists of triangles that consensus accepted
  /// Parallel to fans.neighbors: the half weight of the edge by the fan of its first end, dimensionless, >= 0 for scheme
  /// voronoi. Stiffness off the diagonal is minus the mean of both half weights.
  std::vector<double> weights;
  std::vector<double> mass;              ///< m: lumped mass, length^2, > 0
  std::vector<Triangle> meshTriangles;   ///< scheme mesh only, corners are sites
  DiscretizationTimes times;

  Index size() const { return sites.size(); }
};

/// Throws InvalidInput where a value is out of range.
void checkOptions(const DiscretizationOptions& options);

/// Throws InvalidInput where scheme mesh is asked for and there are no triangles, or a value is out of range.
Discretization discretize(const PointSet& points, const DiscretizationOptions& options, Progress& progress);

}  // namespace stipple
