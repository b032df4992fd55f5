#include "plugins/inpainting/color_tensor.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/fem/gradient.h"
#include "core/pde/diffusion.h"

namespace stipple {

namespace {

// Rounds of averaging over fans. Found on a straight edge across a hole of 12 spacings and on a scan: with
// fewer, noise passes for edges; with more, edges close to each other blend.
constexpr int kRounds = 10;
// Coherence (l0 - l1) / (l0 + l1) that no edge has, and that every edge has.
constexpr double kNoEdge = 0.5, kEdge = 0.8;
// Gradients count from this share of their mean square over the mask on.
constexpr double kFaintShare = 0.03;
constexpr double kLeastAcross = 1e-3, kLeastClassifier = 1e-3;

// J by its entries xx, yy, zz, xy, xz, yz; rows are sites.
using Structure = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;

Structure structureOf(const Hole& hole, const Progress* progress) {
  const Discretization& d = hole.discretization;
  Structure structure = Structure::Zero(d.size(), 6);
  std::vector<double> channel(d.size());
  for (Eigen::Index c = 0; c < hole.values.cols(); ++c) {
    Eigen::VectorXd::Map(channel.data(), hole.values.rows()) = hole.values.col(c);
    const std::vector<Eigen::Vector3d> gradients = fanGradient(d, channel, progress);
    for (Index i = 0; i < d.size(); ++i) {
      const Eigen::Vector3d& g = gradients[i];
      structure.row(i).head<3>() += g.cwiseAbs2();
      structure.row(i).tail<3>() += Eigen::RowVector3d(g.x() * g.y(), g.x() * g.z(), g.y() * g.z());
    }
  }
  return structure;
}

// 1 where the gradient comes from known values alone, in whichever fan.
std::vector<std::uint8_t> findClean(const Hole& hole) {
  const Fans& fans = hole.discretization.fans;
  std::vector<std::uint8_t> isUnknown(fans.size(), 0), isClean(fans.size(), 1);
  for (const Index site : hole.unknown) isUnknown[site] = 1;
  for (Index site = 0; site < fans.size(); ++site) {
    for (const Index neighbor : fans.of(site)) {
      if (isUnknown[neighbor]) isClean[site] = 0;
      if (isUnknown[site]) isClean[neighbor] = 0;
    }
    if (isUnknown[site]) isClean[site] = 0;
  }
  return isClean;
}

// Means over the fans, of and from the sites chosen.
void average(const Fans& fans, std::span<const std::uint8_t> chosen, Structure& structure,
             const Progress* progress) {
  Structure means = structure;
  parallelFor(
      fans.size(), 2048,
      [&](std::size_t begin, std::size_t end) {
        for (auto site = static_cast<Index>(begin); site < end; ++site) {
          if (!chosen[site]) continue;
          double count = 1;
          for (const Index neighbor : fans.of(site)) {
            if (!chosen[neighbor]) continue;
            means.row(site) += structure.row(neighbor);
            ++count;
          }
          means.row(site) /= count;
        }
      },
      progress);
  structure = std::move(means);
}

// Harmonic: components of J between known ones, free of creases.
void continueInto(const Hole& hole, std::span<const std::uint8_t> isClean, Structure& structure,
                  const Progress* progress) {
  std::vector<Index> open;
  for (Index site = 0; site < isClean.size(); ++site) {
    if (!isClean[site]) open.push_back(site);
  }
  SparseMatrix stiffness = assembleStiffness(hole.discretization, progress);
  makeSemidefinite(hole.discretization, stiffness);
  Eigen::MatrixXd entries = structure;
  EllipticSolver(stiffness, open,
                 {.method = open.size() < 50000 ? SolverMethod::kCholesky : SolverMethod::kAuto,
                  .tolerance = 1e-4,
                  .expectedSolves = 6},
                 progress)
      .solve(entries, progress);
  structure = entries;
}

Eigen::Matrix3d tensorOf(const Eigen::Matrix<double, 1, 6>& j, double faint) {
  Eigen::Matrix3d matrix;
  matrix << j[0], j[3], j[4], j[3], j[1], j[5], j[4], j[5], j[2];
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(matrix);
  const double l0 = std::max(0.0, solver.eigenvalues()[2]), l1 = std::max(0.0, solver.eigenvalues()[1]);
  if (!(l0 > 0)) return Eigen::Matrix3d::Identity();
  const double t = std::clamp(((l0 - l1) / (l0 + l1) - kNoEdge) / (kEdge - kNoEdge), 0.0, 1.0);
  const double edge = t * t * (3 - 2 * t) * l0 / (l0 + faint);
  const double a = std::max(kLeastAcross, (1 - edge) * (1 - edge));
  const Eigen::Vector3d across = solver.eigenvectors().col(2);
  return Eigen::Matrix3d::Identity() - (1 - a) * across * across.transpose();
}

}  // namespace

std::vector<Eigen::Matrix3d> edgeTensors(const Hole& hole, EdgeSource source, const Progress* progress) {
  const Discretization& d = hole.discretization;
  Structure structure = structureOf(hole, progress);
  const bool fromKnown = source == EdgeSource::kKnown;
  const std::vector<std::uint8_t> chosen =
      fromKnown ? findClean(hole) : std::vector<std::uint8_t>(d.size(), 1);
  for (int round = 0; round < kRounds; ++round) average(d.fans, chosen, structure, progress);
  if (fromKnown) continueInto(hole, chosen, structure, progress);

  double sum = 0;
  for (const Index site : hole.unknown) sum += structure.row(site).head<3>().sum();
  const double faint = kFaintShare * sum / static_cast<double>(std::max<std::size_t>(hole.unknown.size(), 1));
  std::vector<Eigen::Matrix3d> tensors(d.size());
  parallelFor(
      d.size(), 2048,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          tensors[i] = std::max(kLeastClassifier, hole.classifier[i]) *
                       tensorOf(structure.row(static_cast<Eigen::Index>(i)), faint);
        }
      },
      progress);
  return tensors;
}

}  // namespace stipple
