#include "core/fem/point_rows.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>

#include "core/fem/assembly.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

Discretization discretized(std::vector<Eigen::Vector3f> positions) {
  Progress progress;
  return discretize(PointSet(std::move(positions)), {}, progress);
}

Eigen::MatrixXd dense(const PointRows& rows) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows.size(), rows.size());
  std::vector<PointRows::Entry> entries;
  std::size_t count = 0;
  for (Index p = 0; p < rows.size(); ++p) {
    rows.lowerRow(p, entries);
    count += entries.size();
    for (const auto& [column, value] : entries) matrix(p, column) = matrix(column, p) = value;
  }
  EXPECT_EQ(count, rows.countLower());
  return matrix;
}

TEST(PointRows, CopiesOfAPlaceShareItsRow) {
  auto positions = shapes::randomSphere(300);
  const auto copies = positions;
  positions.insert(positions.begin() + 100, copies.begin(), copies.begin() + 40);
  positions.insert(positions.end(), copies.begin(), copies.begin() + 10);
  const Discretization d = discretized(positions);
  const SparseMatrix sites = assembleStiffness(d);
  const Eigen::MatrixXd points = dense(PointRows(d.sites, sites));
  ASSERT_EQ(points.rows(), 350);

  // W averages the copies of each place.
  Eigen::MatrixXd average = Eigen::MatrixXd::Zero(300, 350);
  for (Index p = 0; p < 350; ++p) average(d.sites.siteOfPoint[p], p) = 1;
  for (Eigen::Index s = 0; s < 300; ++s) average.row(s) /= average.row(s).sum();
  const Eigen::MatrixXd expected = average.transpose() * Eigen::MatrixXd(sites) * average;
  EXPECT_LT((points - expected).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((points * Eigen::VectorXd::Ones(350)).cwiseAbs().maxCoeff(), 1e-12);

  const std::vector<double> mass = expandMassToPoints(d.sites, d.mass);
  EXPECT_NEAR(std::accumulate(mass.begin(), mass.end(), 0.0),
              std::accumulate(d.mass.begin(), d.mass.end(), 0.0), 1e-9);
}

TEST(PointRows, PointsAtOnePlaceAreNotTied) {
  const Discretization d = discretized(std::vector<Eigen::Vector3f>(200000, Eigen::Vector3f(1, 2, 3)));
  const SparseMatrix stiffness = assembleStiffness(d);
  EXPECT_EQ(PointRows(d.sites, stiffness).countLower(), 200000u);  // a zero diagonal
}

TEST(PointRows, TooManyCopiesAreRefusedBeforeTheyAreMade) {
  auto positions = shapes::randomSphere(100);
  positions.insert(positions.end(), 200000, positions[0]);
  const Discretization d = discretized(positions);
  const SparseMatrix stiffness = assembleStiffness(d);
  EXPECT_THROW(PointRows(d.sites, stiffness).countLower(), InvalidInput);
}

}  // namespace
}  // namespace stipple
