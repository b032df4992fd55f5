#include "plugins/inpainting/hole.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/moments.h"
#include "core/geometry/nearest_points.h"
#include "core/points/field.h"
#include "plugins/inpainting/mask_patch.h"

namespace stipple {

namespace {

constexpr int kClassifierNeighbors = 30;
constexpr double kUnitTolerance = 1e-3;

// The values of known sites; which sites are unknown.
void gatherValues(const Attribute& attribute, const Region& region, const MaskPatch& patch, Hole& hole) {
  const Sites& sites = hole.discretization.sites;
  const Eigen::MatrixXd given = readField(attribute, patch.rows);
  std::vector<std::uint8_t> isKnown(sites.size(), 0);
  hole.values = Eigen::MatrixXd::Constant(sites.size(), given.cols(), std::nan(""));
  for (Index p = 0; p < patch.rows.size(); ++p) {
    const Index site = sites.siteOfPoint[p];
    const bool isFinite = given.row(p).allFinite(), isMasked = region.contains(patch.rows[p]);
    if (isMasked) {
      hole.maskedRows.push_back(patch.rows[p]);
      hole.siteOfRow.push_back(site);
    }
    if (isKnown[site] || !isFinite) continue;
    hole.values.row(site) = given.row(p);
    isKnown[site] = !isMasked;
  }
  for (Index site = 0; site < sites.size(); ++site) {
    if (!isKnown[site]) hole.unknown.push_back(site);
  }
}

void summarizeKnown(const PointSet& points, const Attribute& attribute, const Region& region, Hole& hole) {
  const int channels = channelsOf(attribute.type());
  hole.least = Eigen::RowVectorXd::Constant(channels, std::numeric_limits<double>::infinity());
  hole.greatest = -hole.least;
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(channels);
  double count = 0;
  hole.areUnitVectors = attribute.type() == AttributeType::kVector3;
  hole.isLight = attribute.type() == AttributeType::kColor;
  constexpr Index kBlock = 1 << 16;
  std::vector<Index> rows;
  for (Index begin = 0; begin < points.size(); begin += kBlock) {
    rows.clear();
    for (Index row = begin; row < std::min(points.size(), begin + kBlock); ++row) {
      if (!region.contains(row)) rows.push_back(row);
    }
    const Eigen::MatrixXd values = readField(attribute, rows);
    for (Eigen::Index r = 0; r < values.rows(); ++r) {
      if (!values.row(r).allFinite()) continue;
      hole.least = hole.least.cwiseMin(values.row(r));
      hole.greatest = hole.greatest.cwiseMax(values.row(r));
      sum += values.row(r);
      ++count;
      if (std::abs(values.row(r).norm() - 1) > kUnitTolerance) hole.areUnitVectors = false;
    }
  }
  if (count == 0)
    throw InvalidInput(fmt::format(
        "attribute \"{}\" has no value outside the mask that it could be filled from", attribute.name));
  for (const Index site : hole.unknown) {
    if (!hole.values.row(site).allFinite()) hole.values.row(site) = sum / count;
  }
}

}  // namespace

void makeSemidefinite(const Discretization& d, SparseMatrix& stiffness) {
  if (d.options.scheme == Scheme::kPaper || d.options.scheme == Scheme::kMesh) dropNegativeWeights(stiffness);
}

Hole prepareHole(const PointSet& points, const Attribute& attribute, const Region& region,
                 const DiscretizationOptions& options, Progress& progress) {
  const std::vector<Index> masked = region.rows(points.size());
  progress.report(0, "the surface around the mask");
  // Triangles of a file may reach farther than points lie apart.
  const MaskPatch patch =
      options.scheme == Scheme::kMesh ? wholePatch(points) : cutPatch(points, masked, &progress);
  PartialProgress discretizing(progress, 0.1, 0.8);
  Hole hole{.discretization = discretize(patch.points, options, discretizing)};
  const Sites& sites = hole.discretization.sites;
  const std::vector<float> classifier = classify(fitMoments(sites, kClassifierNeighbors, &progress));
  hole.classifier.assign(classifier.begin(), classifier.end());
  gatherValues(attribute, region, patch, hole);
  summarizeKnown(points, attribute, region, hole);
  return hole;
}

Eigen::MatrixXd nearestKnownValues(const PointSet& points, const Attribute& attribute, const Region& region,
                                   const Hole& hole, std::span<const Index> sites, const Progress* progress) {
  std::vector<Index> known;
  std::vector<Eigen::Vector3f> positions, queries;
  for (Index row = 0; row < points.size(); ++row) {
    if (region.contains(row) || !readField(attribute, {&row, 1}).allFinite()) continue;
    known.push_back(row);
    positions.push_back(points.positions()[row]);
  }
  for (const Index site : sites) queries.push_back(hole.discretization.sites.positions[site]);
  std::vector<Index> rows = findNearestPoints(positions, queries, progress);
  for (Index& row : rows) row = known[row];
  return readField(attribute, rows);
}

}  // namespace stipple
