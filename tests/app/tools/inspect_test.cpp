#include "app/tools/inspect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "core/fem/assembly.h"
#include "core/io/point_io.h"
#include "tests/support/shapes.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

/// The discretization of all points, with its matrix.
struct Whole {
  explicit Whole(const PointSet& points) {
    Progress progress;
    d = discretize(points, {}, progress);
    stiffness = assembleStiffness(d);
  }
  Index rowOf(Index site) const { return d.sites.pointOfSite[site]; }

  std::set<std::set<Index>> fanOf(Index site) const {
    std::set<std::set<Index>> fan;
    const auto spokes = d.fans.of(site);
    for (std::size_t s = 0; s < spokes.size(); ++s) {
      if (d.fans.flagsOf(site)[s] & Fans::kGapAfter) continue;
      fan.insert({rowOf(site), rowOf(spokes[s]), rowOf(spokes[(s + 1) % spokes.size()])});
    }
    return fan;
  }

  Discretization d;
  SparseMatrix stiffness;
};

void expectSame(const PointInspection& inspection, const Whole& whole) {
  const Index site = whole.d.sites.siteOfPoint[inspection.row];
  std::set<std::set<Index>> fan;
  for (const Triangle& t : inspection.fan) fan.insert({t[0], t[1], t[2]});
  EXPECT_EQ(fan, whole.fanOf(site)) << "row " << inspection.row;
  EXPECT_NEAR(inspection.mass, whole.d.mass[site], 1e-9 * whole.d.mass[site]);
  EXPECT_EQ(inspection.isOpen, whole.d.fans.open[site] != 0);
  EXPECT_EQ(inspection.isCertified, whole.d.fans.certified[site] != 0);
  EXPECT_EQ(inspection.isResolved, whole.d.resolved[site] != 0);

  std::vector<std::pair<Index, double>> row;
  for (SparseMatrix::InnerIterator e(whole.stiffness, static_cast<Eigen::Index>(site)); e; ++e)
    row.emplace_back(whole.rowOf(static_cast<Index>(e.col())), e.value());
  std::ranges::sort(row);
  ASSERT_EQ(inspection.matrixRow.size(), row.size()) << "row " << inspection.row;
  for (std::size_t e = 0; e < row.size(); ++e) {
    EXPECT_EQ(inspection.matrixRow[e].column, row[e].first);
    EXPECT_NEAR(inspection.matrixRow[e].value, row[e].second, 1e-9 * (1 + std::abs(row[e].second)));
  }
}

std::vector<Eigen::Vector3f> noisySphere(std::size_t count, float noise) {
  std::vector<Eigen::Vector3f> positions = shapes::randomSphere(count);
  std::mt19937 random(5);
  std::normal_distribution<float> normal(0, noise);
  for (Eigen::Vector3f& p : positions) p *= 1 + normal(random);
  return positions;
}

TEST(InspectPoint, IsTheRowOfTheWholeDiscretization) {
  // Spacing .025; with noise the fans disagree, and their disputes join.
  for (const float noise : {0.f, 0.004f, 0.008f}) {
    const PointSet points(noisySphere(20000, noise));
    const Whole whole(points);
    for (Index row = 0; row < 20000; row += 2503) {
      const PointInspection inspection = inspectPoint(points, row);
      EXPECT_TRUE(inspection.isSettled);
      expectSame(inspection, whole);
    }
  }
}

TEST(InspectPoint, IsTheRowOfAScan) {
  STIPPLE_NEEDS_TEST_DATA();
  Progress progress;
  const PointSet points = readPoints(testData("smooth/bunny70k_meshlab.ply"), progress).points;
  const Whole whole(points);
  for (Index row = 0; row < points.size(); row += points.size() / 40)
    expectSame(inspectPoint(points, row), whole);
}

TEST(InspectPoint, MatrixRowsSumToZeroAndFansTurnAboutTheNormal) {
  PointSet points(shapes::randomSphere(5000));
  std::vector<Eigen::Vector3f> outwards(points.positions().begin(), points.positions().end());
  points.set("normal", outwards);
  for (Index row = 0; row < 5000; row += 499) {
    const PointInspection inspection = inspectPoint(points, row);
    double sum = 0;
    for (const MatrixEntry& entry : inspection.matrixRow) sum += entry.value;
    EXPECT_NEAR(sum, 0, 1e-9);
    EXPECT_GT(inspection.normal.dot(outwards[row]), 0.9f);
    ASSERT_FALSE(inspection.fan.empty());
    for (std::size_t t = 0; t < inspection.fan.size(); ++t) {
      const auto& [site, a, b] = inspection.fan[t];
      EXPECT_EQ(site, row);
      EXPECT_GT((outwards[a] - outwards[site]).cross(outwards[b] - outwards[site]).dot(inspection.normal), 0);
      if (!inspection.isOpen) {
        EXPECT_EQ(b, inspection.fan[(t + 1) % inspection.fan.size()][1]);
      }
    }
  }
}

TEST(InspectPoint, MomentsAreThoseOfThirtyNeighbors) {
  const PointSet points(shapes::randomSquare(3000));
  const Sites sites = weldAndOrder(points.positions());
  const Neighborhoods neighborhoods = findNeighborhoods(sites, {});
  const std::vector<Moments> moments = fitMoments(sites, neighborhoods);
  for (Index row = 0; row < 3000; row += 301) {
    const PointInspection inspection = inspectPoint(points, row);
    const Index site = sites.siteOfPoint[row];
    ASSERT_EQ(inspection.neighbors.size(), 30u);
    for (std::size_t n = 0; n < 30; ++n)
      EXPECT_EQ(inspection.neighbors[n], sites.pointOfSite[neighborhoods.of(site)[n]]);
    EXPECT_LT((inspection.moments.eigenvalues - moments[site].eigenvalues).norm(), 1e-7f);
    EXPECT_EQ(inspection.classifier, 1) << "it is flat";
    EXPECT_LT(inspection.steepestTurn, 1e-3f);
  }
}

TEST(InspectPoint, SeesACrease) {
  // Two halves of a square at a right angle.
  std::vector<Eigen::Vector3f> positions = shapes::randomSquare(4000);
  for (Eigen::Vector3f& p : positions)
    if (p.x() > 0.5f) p = {0.5f, p.y(), p.x() - 0.5f};
  const PointSet points(positions);
  Index atCrease = 0, apart = 0;
  for (Index row = 0; row < points.size(); ++row) {
    const auto off = [&](Index r) { return (positions[r] - Eigen::Vector3f(0.5f, 0.5f, 0)).norm(); };
    const auto fromFlat = [&](Index r) { return (positions[r] - Eigen::Vector3f(0.2f, 0.5f, 0)).norm(); };
    if (off(row) < off(atCrease)) atCrease = row;
    if (fromFlat(row) < fromFlat(apart)) apart = row;
  }
  EXPECT_LT(inspectPoint(points, atCrease).classifier, 0.5f);
  EXPECT_NEAR(inspectPoint(points, atCrease).steepestTurn, 1.5708f, 0.02f);
  EXPECT_GT(inspectPoint(points, apart).classifier, 0.99f);
  EXPECT_LT(inspectPoint(points, apart).steepestTurn, 0.02f);
}

TEST(InspectPoint, DoesNotLookAtAllPoints) {
  // Far from the point lies one that discretize would refuse to have in a set.
  std::vector<Eigen::Vector3f> positions = shapes::randomSphere(20000);
  positions.emplace_back(std::numeric_limits<float>::infinity(), 0.f, 0.f);
  const PointSet points(positions);
  Progress progress;
  EXPECT_THROW(discretize(points, {}, progress), InvalidInput);
  const PointInspection inspection = inspectPoint(points, 7);
  EXPECT_TRUE(inspection.isSettled);
  EXPECT_TRUE(inspection.isCertified);
}

TEST(InspectPoint, CanBeCancelled) {
  class Stopped final : public Progress {
   public:
    bool cancelled() const override { return true; }
  } progress;
  EXPECT_THROW(inspectPoint(PointSet(shapes::randomSphere(2000)), 7, {}, &progress), Cancelled);
}

TEST(InspectPoint, DegenerateSetsHaveAnAnswer) {
  EXPECT_TRUE(inspectPoint(PointSet({{1, 2, 3}}), 0).fan.empty());
  EXPECT_TRUE(inspectPoint(PointSet(std::vector<Eigen::Vector3f>(3000, {1, 2, 3})), 5).fan.empty());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<Eigen::Vector3f> positions = shapes::randomSquare(200);
  positions.emplace_back(nan, 0.f, 0.f);
  EXPECT_FALSE(inspectPoint(PointSet(positions), 0).fan.empty()) << "others may have no place";
  EXPECT_THROW(inspectPoint(PointSet(positions), 200), InvalidInput);
  EXPECT_THROW(inspectPoint(PointSet(positions), 201), InvalidInput);
}

TEST(InspectPoint, CopiesOfAPlaceHaveItsFirstRow) {
  std::vector<Eigen::Vector3f> positions = shapes::randomSquare(2000);
  positions.insert(positions.end(), positions.begin(), positions.begin() + 1000);
  const PointSet points(positions);
  const Whole whole(points);
  PointInspection inspection = inspectPoint(points, 2017);
  EXPECT_EQ(inspection.row, 2017u);
  ASSERT_FALSE(inspection.fan.empty());
  EXPECT_EQ(inspection.fan.front()[0], 17u);
  expectSame(inspection, whole);
}

}  // namespace
}  // namespace stipple
