#include "plugins/inpainting/mask_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/fem/assembly.h"
#include "tests/plugins/inpainting/inpaint_points.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

// Rows of the stiffness matrix at `rows`, by rows of the whole set.
std::map<std::pair<Index, Index>, double> matrixAt(const MaskPatch& patch, std::span<const Index> rows) {
  Progress progress;
  const Discretization d = discretize(patch.points, {}, progress);
  const SparseMatrix stiffness = assembleStiffness(d);
  std::map<std::pair<Index, Index>, double> entries;
  for (const Index row : rows) {
    const auto place =
        static_cast<std::size_t>(std::ranges::lower_bound(patch.rows, row) - patch.rows.begin());
    for (SparseMatrix::InnerIterator e(stiffness, d.sites.siteOfPoint[place]); e; ++e)
      entries[{row, patch.rows[d.sites.pointOfSite[static_cast<std::size_t>(e.col())]]}] = e.value();
  }
  return entries;
}

TEST(MaskPatch, GivesTheEquationsOfTheWholeSet) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const PointSet points(shapes::randomSphere(30000, seed));
    const std::vector<Index> masked = rowsAround(points, {0, 0, 1}, 0.2f);
    const MaskPatch patch = cutPatch(points, masked);
    EXPECT_LT(patch.rows.size(), points.size() / 3);
    EXPECT_TRUE(std::ranges::includes(patch.rows, masked));
    const auto here = matrixAt(patch, masked), whole = matrixAt(wholePatch(points), masked);
    ASSERT_EQ(here.size(), whole.size());
    for (const auto& [place, value] : whole) {
      ASSERT_TRUE(here.contains(place));
      EXPECT_NEAR(here.at(place), value, 1e-6);
    }
  }
}

TEST(MaskPatch, GrowsWhereTheMaskIsSparserThanTheScan) {
  std::vector<Eigen::Vector3f> positions = shapes::randomSquare(20000);
  for (const Eigen::Vector3f& p : shapes::randomSquare(200, 2))
    positions.push_back(20 * p + Eigen::Vector3f(2, 0, 0));
  const PointSet points(positions);
  const std::vector<Index> masked = rowsAround(points, {12, 10, 0}, 2);
  ASSERT_GT(masked.size(), 1u);
  const MaskPatch patch = cutPatch(points, masked);
  EXPECT_TRUE(std::ranges::includes(patch.rows, rowsAround(points, {12, 10, 0}, 7)));
}

TEST(MaskPatch, OfFewPointsIsTheWhole) {
  for (const int side : {1, 2, 4}) {
    const PointSet points(shapes::grid(std::max(side, 2)));
    const std::vector<Index> masked{0};
    EXPECT_EQ(cutPatch(points, masked).rows.size(), points.size());
  }
  const PointSet same(std::vector<Eigen::Vector3f>(40, Eigen::Vector3f(1, 1, 1)));
  const std::vector<Index> masked{3};
  EXPECT_EQ(cutPatch(same, masked).rows.size(), 40u);
}

}  // namespace
}  // namespace stipple
