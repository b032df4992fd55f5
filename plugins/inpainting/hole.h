#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/fem/assembly.h"
#include "core/points/region.h"

namespace stipple {

/// The surface in and around a mask, and what is known of an attribute there. Rows of everything are the
/// sites of the discretization.
struct Hole {
  Discretization discretization;
  std::vector<double> classifier;  ///< C in (0, 1], at the mask and its rim; see classify()
  /// Sites x channels. Unknown ones begin with what the attribute has there, or the mean of the known ones.
  Eigen::MatrixXd values;
  std::vector<Index> unknown;     ///< ascending: sites whose points are all masked or have no finite value
  std::vector<Index> maskedRows;  ///< rows of the point set that are to be written, ascending
  std::vector<Index> siteOfRow;   ///< parallel to maskedRows

  /// Least and greatest known value of each channel.
  Eigen::RowVectorXd least, greatest;
  /// Where known vectors are all of unit length, so are those that are filled in.
  bool areUnitVectors = false;
  /// The values are colors, in linear light.
  bool isLight = false;
};

/// Schemes paper and mesh have weights below 0 at obtuse angles, with which div(A grad u) = 0 may have no
/// stable solution: they become 0, rows still sum to 0. The other schemes stay as they are.
void makeSemidefinite(const Discretization& d, SparseMatrix& stiffness);

/// Throws InvalidInput where the attribute has no known value at all.
Hole prepareHole(const PointSet& points, const Attribute& attribute, const Region& region,
                 const DiscretizationOptions& options, Progress& progress);

/// Values of the known point nearest to each of the sites, in space.
Eigen::MatrixXd nearestKnownValues(const PointSet& points, const Attribute& attribute, const Region& region,
                                   const Hole& hole, std::span<const Index> sites, const Progress* progress);

}  // namespace stipple
