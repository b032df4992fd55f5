#include "render/hierarchy/hierarchy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>

#include "render/appearance/light.h"
#include "render/hierarchy/build.h"
#include "render/hierarchy/refit.h"
#include "render/hierarchy/sort_leaves.h"
#include "tests/support/sampled_hierarchy.h"

namespace stipple {
namespace {

struct Children {
  Index begin, end;
};

/// Calls visit(parent, children) for all inner nodes, from the leaves up; indices among all nodes.
void forInnerNodes(const Hierarchy& h, const std::function<void(Index, Children)>& visit) {
  for (int level = 1; level < h.levelCount(); ++level) {
    const Index below = h.levelBegin(level - 1);
    for (Index i = 0; i < h.levelSize(level); ++i) {
      const Index end = std::min(4 * i + 4, h.levelSize(level - 1));
      visit(h.levelBegin(level) + i, {below + 4 * i, below + end});
    }
  }
}

glm::vec3 linearColor(const Rgba8& c) {
  return {linearTable()[c.r], linearTable()[c.g], linearTable()[c.b]};
}

void expectParentsHoldTheirChildren(const Hierarchy& h) {
  const auto splats = h.splats();
  forInnerNodes(h, [&](Index parent, Children children) {
    for (Index child = children.begin; child < children.end; ++child) {
      const double reach =
          glm::distance(glm::dvec3(splats[parent].center()), glm::dvec3(splats[child].center())) +
          h.boundingRadius(child);
      // In double: not even rounding lets a child out, apart from that of the stored centers.
      ASSERT_LE(reach, h.bound(parent).radius * (1 + 1e-7)) << parent << " " << child;
    }
  });
}

/// All leaves' discs are inside the root's sphere, all leaf normals within the cones of their ancestors.
void expectConesHoldTheLeaves(const Hierarchy& h) {
  const auto splats = h.splats();
  for (Index leaf = 0; leaf < h.leafCount(); ++leaf) {
    Index inLevel = leaf;
    const glm::vec3 normal = unpackNormal(splats[leaf].shape);
    for (int level = 1; level < h.levelCount(); ++level) {
      inLevel /= 4;
      const Index node = h.levelBegin(level) + inLevel;
      ASSERT_LE(glm::distance(splats[node].center(), splats[leaf].center()) + splats[leaf].radius,
                h.bound(node).radius * (1 + 1e-5f));
      const float turned = glm::dot(normal, unpackNormal(splats[node].shape));
      const float cosine = h.bound(node).cosine;
      if (cosine <= 0) continue;  // no cone
      ASSERT_GE(turned, cosine - 1e-4f) << "leaf " << leaf << " level " << level;
    }
  }
}

void expectMeansByArea(const Hierarchy& h) {
  const auto splats = h.splats();
  forInnerNodes(h, [&](Index parent, Children children) {
    double area = 0;
    glm::dvec3 center(0), color(0), normal(0);
    for (Index child = children.begin; child < children.end; ++child) {
      const double a = areaOf(splats[child]);
      const glm::vec3 n = unpackNormal(splats[child].shape);
      area += a;
      center += a * glm::dvec3(splats[child].center());
      color += a * glm::dvec3(linearColor(splats[child].color));
      normal += (glm::dot(normal, glm::dvec3(n)) < 0 ? -a : a) * glm::dvec3(n);
    }
    const Splat& s = splats[parent];
    // The means and the rounding of their coordinates.
    const double scale = s.radius + 3e-3 * glm::length(s.center());
    ASSERT_LT(glm::distance(glm::dvec3(s.center()), center / area), 1e-4 * scale);
    ASSERT_NEAR(areaOf(s) / area, 1, 1e-5);
    const int level = parent < h.levelBegin(2) ? 1 : h.levelCount() < 3 || parent < h.levelBegin(3) ? 2 : 3;
    ASSERT_NEAR(s.radius, radiusOfArea(level) * std::sqrt(area), 1e-4 * s.radius);
    const glm::dvec3 mean = color / area;
    ASSERT_LE(std::abs(s.color.r - 255 * srgbFromLinear(float(mean.x))), 0.55);
    ASSERT_LE(std::abs(s.color.g - 255 * srgbFromLinear(float(mean.y))), 0.55);
    ASSERT_LE(std::abs(s.color.b - 255 * srgbFromLinear(float(mean.z))), 0.55);
    if (glm::length(normal) > 1e-3 * area) {
      ASSERT_GT(glm::dot(glm::normalize(normal), glm::dvec3(unpackNormal(s.shape))), 1 - 1e-5);
    }
  });
}

void expectInvariants(const Hierarchy& h) {
  expectParentsHoldTheirChildren(h);
  expectConesHoldTheLeaves(h);
  expectMeansByArea(h);
}

void expectPermutation(const Hierarchy& h) {
  ASSERT_EQ(h.pointOfSlot.size(), h.leafCount());
  ASSERT_EQ(h.slotOfPoint.size(), h.leafCount());
  for (Index slot = 0; slot < h.leafCount(); ++slot) ASSERT_EQ(h.slotOfPoint[h.pointOfSlot[slot]], slot);
}

TEST(Hierarchy, HasOneNodeForEachFourUpToASingleRoot) {
  for (const Index count : {1u, 2u, 3u, 4u, 5u, 16u, 17u, 64u, 65u, 1000u}) {
    const Hierarchy h(count);
    EXPECT_EQ(h.levelBegin(0), 0u);
    EXPECT_EQ(h.levelSize(0), count);
    EXPECT_EQ(h.levelSize(h.levelCount() - 1), 1u);
    for (int level = 1; level < h.levelCount(); ++level) {
      EXPECT_EQ(h.levelSize(level), (h.levelSize(level - 1) + 3) / 4) << count;
      EXPECT_GT(h.levelSize(level - 1), 1u) << count;
    }
    EXPECT_EQ(h.nodeCount(), h.levelBegin(h.levelCount() - 1) + 1);
  }
}

TEST(Hierarchy, NormalsComeBackFromTheirBits) {
  std::mt19937_64 random(2);
  std::normal_distribution<float> normal;
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 n = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
    const float ratio = std::exp2(0.0002f * static_cast<float>(i) - 3);
    const std::uint32_t shape = packShape(5.f * n, ratio);
    EXPECT_LT(glm::distance(unpackNormal(shape), n),
              1.05e-3f);  // half a step of 4096 in both, at the middle of an octant
    EXPECT_NEAR(unpackAreaRatio(shape) / ratio, 1, 0.012);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.f, 1.f}) {
      glm::vec3 n(0);
      n[axis] = sign;
      EXPECT_LT(glm::distance(unpackNormal(packShape(n, 1)), n), 5e-4f);
    }
  }
}

TEST(Hierarchy, KeepsItsInvariantsOnSurfaces) {
  for (const scenes::Scene& scene : scenes::allScenes()) {
    for (const LeafOrder order : {LeafOrder::kKd, LeafOrder::kMorton}) {
      SCOPED_TRACE(scene.name);
      const Hierarchy h = sampledHierarchy(scene, 20011, 3, order);
      expectPermutation(h);
      expectInvariants(h);
    }
  }
}

TEST(Hierarchy, LeavesAreThePoints) {
  const scenes::SurfaceSamples samples = scenes::rippledTorus().sample(5000, 4);
  std::vector<float> radii(5000), areas(5000);
  for (Index i = 0; i < 5000; ++i) {
    radii[i] = 0.01f + 1e-6f * static_cast<float>(i);
    areas[i] = 0.3f * radii[i] * radii[i];
  }
  LeafAttributes leaves = leavesOf(samples);
  leaves.radii = radii;
  leaves.areas = areas;
  const Hierarchy h = buildHierarchy(leaves, LeafOrder::kKd);
  for (Index point = 0; point < 5000; ++point) {
    const Splat& splat = h.splats()[h.slotOfPoint[point]];
    const Eigen::Vector3f& p = samples.positions[point];
    const Eigen::Vector3f& n = samples.normals[point];
    EXPECT_EQ(splat.center(), glm::vec3(p.x(), p.y(), p.z()));
    EXPECT_EQ(splat.radius, radii[point]);
    EXPECT_EQ(splat.color, samples.colors[point]);
    EXPECT_NEAR(areaOf(splat) / areas[point], 1, 0.025);
    EXPECT_LT(glm::distance(unpackNormal(splat.shape), {n.x(), n.y(), n.z()}), 1.05e-3f);
  }
}

// Mean over a level of what holds its nodes' leaves.
double meanBound(const Hierarchy& h, int level) {
  double sum = 0;
  for (Index i = 0; i < h.levelSize(level); ++i) sum += h.boundingRadius(h.levelBegin(level) + i);
  return sum / h.levelSize(level);
}

TEST(Hierarchy, KdNodesOfASurfaceDoubleFromLevelToLevel) {
  const Hierarchy h = sampledHierarchy(scenes::rippledTorus(), 1 << 16);
  // Four times the area is twice the size; a poor order grows faster.
  for (int level = 2; level < 7; ++level)
    EXPECT_LT(meanBound(h, level), 2.1 * meanBound(h, level - 1)) << level;
}

// Moves, colors and turns random leaves.
std::vector<Index> editLeaves(Hierarchy& h, std::mt19937_64& random, std::size_t count) {
  std::normal_distribution<float> normal;
  std::vector<Index> slots;
  for (std::size_t i = 0; i < count; ++i) {
    const Index slot = static_cast<Index>(random() % h.leafCount());
    Splat& s = h.editSplats()[slot];
    s.x += 0.02f * normal(random);
    s.y += 0.02f * normal(random);
    s.radius *= std::exp(0.3f * normal(random));
    s.shape = packShape({normal(random), normal(random), normal(random)}, 0.7f);
    s.color = {static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()), 7, 255};
    slots.push_back(slot);
  }
  return slots;
}

TEST(Hierarchy, RefitAfterEditsIsTheWholeAggregationBitForBit) {
  std::mt19937_64 random(9);
  Hierarchy edited = sampledHierarchy(scenes::carvedCube(), 30011);
  Hierarchy fresh = sampledHierarchy(scenes::carvedCube(), 30011);
  for (const std::size_t count : {1u, 10u, 3000u, 1u, 20000u}) {
    const std::vector<Index> slots = editLeaves(edited, random, count);
    const std::vector<Splat> before(edited.splats().begin(), edited.splats().end());
    const std::vector<NodeRange> ranges = refit(edited, slots);
    std::copy_n(edited.splats().begin(), edited.leafCount(), fresh.editSplats().begin());
    refitAll(fresh);
    EXPECT_TRUE(sameNodes(edited, fresh)) << count;
    expectParentsHoldTheirChildren(edited);
    // What changed lies in the ranges, which are ascending and apart.
    std::vector<std::uint8_t> isListed(edited.nodeCount(), 0);
    for (std::size_t r = 0; r < ranges.size(); ++r) {
      EXPECT_LT(ranges[r].begin, ranges[r].end);
      if (r > 0) {
        EXPECT_GT(ranges[r].begin, ranges[r - 1].end);
      }
      for (Index node = ranges[r].begin; node < ranges[r].end; ++node) isListed[node] = 1;
    }
    for (const Index slot : slots) EXPECT_TRUE(isListed[slot]);
    for (Index node = edited.leafCount(); node < edited.nodeCount(); ++node) {
      const Splat &a = before[node], &b = edited.splats()[node];
      if (a.center() != b.center() || a.color != b.color) {
        EXPECT_TRUE(isListed[node]) << node;
      }
    }
  }
  EXPECT_TRUE(refit(edited, {}).empty());
}

// A block of the Morton order may have two parts that are far from each other, and one node over both of them
// a level: these make the means of high levels larger, where a block has few nodes.
TEST(Hierarchy, BlocksSortedInPlaceHaveNodesNearlyAsSmallAsTheKdOrder) {
  constexpr Index kCount = 3 * kSortedLeaves + 12'345;
  const Hierarchy kd = sampledHierarchy(scenes::rippledTorus(), kCount);
  const Hierarchy morton = sampledHierarchy(scenes::rippledTorus(), kCount, 1, LeafOrder::kMorton);
  Hierarchy sorted = sampledHierarchy(scenes::rippledTorus(), kCount, 1, LeafOrder::kMorton);
  for (Index block = 0; block * kSortedLeaves < kCount; ++block) sortLeaves(sorted, block, {});
  for (int level = 1; level < kSortedLevels; ++level) {
    EXPECT_LT(meanBound(sorted, level), (1.08 + 0.08 * level) * meanBound(kd, level)) << level;
    EXPECT_LT(meanBound(sorted, level), 0.9 * meanBound(morton, level)) << level;
  }
}

TEST(Hierarchy, BlocksSortedInPlaceKeepTheirPointsAndAreAggregatedAnew) {
  constexpr Index kCount = 2 * kSortedLeaves + 4321;
  for (const bool fitsNormals : {false, true}) {
    const Hierarchy before = sampledHierarchy(scenes::carvedCube(), kCount, 3, LeafOrder::kMorton);
    Hierarchy h = sampledHierarchy(scenes::carvedCube(), kCount, 3, LeafOrder::kMorton);
    for (const Index block : {2u, 0u}) {
      const std::vector<Splat> last(h.splats().begin(), h.splats().end());
      std::vector<std::uint8_t> isListed(h.nodeCount(), 0);
      for (const NodeRange& range : sortLeaves(h, block, {.fitsNormals = fitsNormals}))
        std::fill(isListed.begin() + range.begin, isListed.begin() + range.end, 1);
      for (Index node = 0; node < h.nodeCount(); ++node) {
        const Splat &a = last[node], &b = h.splats()[node];
        if (a.center() != b.center() || a.shape != b.shape || a.color != b.color) {
          ASSERT_TRUE(isListed[node]) << node;
        }
      }
    }
    expectPermutation(h);
    expectInvariants(h);
    for (Index point = 0; point < kCount; ++point) {
      const Splat &a = before.splats()[before.slotOfPoint[point]], &b = h.splats()[h.slotOfPoint[point]];
      ASSERT_EQ(a.center(), b.center());
      ASSERT_EQ(a.color, b.color);
      if (!fitsNormals) {
        ASSERT_EQ(a.shape, b.shape);
      }
    }
    Hierarchy fresh = h;
    refitAll(fresh);
    EXPECT_TRUE(sameNodes(h, fresh));
  }
}

TEST(Hierarchy, IsTheSameForAnyNumberOfThreads) {
  for (const LeafOrder order : {LeafOrder::kKd, LeafOrder::kMorton}) {
    const Hierarchy onAll = sampledHierarchy(scenes::rippledTorus(), 200'003, 1, order);
    const ThreadLimit one(1);
    EXPECT_TRUE(sameNodes(onAll, sampledHierarchy(scenes::rippledTorus(), 200'003, 1, order)));
  }
}

TEST(Hierarchy, OfFewPoints) {
  for (const Index count : {0u, 1u, 2u, 3u, 5u, 17u}) {
    for (const LeafOrder order : {LeafOrder::kKd, LeafOrder::kMorton}) {
      SCOPED_TRACE(count);
      const Hierarchy h = sampledHierarchy(scenes::checkeredSphere(), count, 1, order);
      EXPECT_EQ(h.leafCount(), count);
      expectPermutation(h);
      expectInvariants(h);
      for (const Splat& splat : h.splats()) EXPECT_TRUE(std::isfinite(splat.radius) && splat.radius > 0);
    }
  }
}

TEST(Hierarchy, OfCopiesAndOfCollinearPoints) {
  std::vector<Eigen::Vector3f> copies(1001, Eigen::Vector3f(1, 2, 3)), line(1001);
  for (int i = 0; i < 1001; ++i) line[i] = Eigen::Vector3f(1, 2, 3) * (0.01f * static_cast<float>(i));
  for (const auto& positions : {copies, line}) {
    for (const LeafOrder order : {LeafOrder::kKd, LeafOrder::kMorton}) {
      LeafAttributes leaves;
      leaves.positions = positions;
      const Hierarchy h = buildHierarchy(leaves, order);
      expectPermutation(h);
      expectInvariants(h);
      for (const Splat& splat : h.splats()) {
        ASSERT_TRUE(std::isfinite(splat.x) && std::isfinite(splat.radius) && splat.radius > 0);
        ASSERT_NEAR(glm::length(unpackNormal(splat.shape)), 1, 1e-5);
      }
    }
  }
}

TEST(Hierarchy, FitsIntoFortyEightBytesAPoint) {
  constexpr Index kCount = 1'000'000;
  const Hierarchy h = sampledHierarchy(scenes::checkeredSphere(), kCount);
  EXPECT_LE(static_cast<double>(h.memoryBytes()) / kCount, 48.0);
}

}  // namespace
}  // namespace stipple
