#include "render/hierarchy/cut.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/sampled_hierarchy.h"

namespace stipple {
namespace {

View torusView(float zoom, Projection projection = Projection::kPerspective) {
  return frameView(scenes::rippledTorus().surface.sphere,
                   {.yaw = 0.3f, .pitch = 0.7f, .zoom = zoom, .projection = projection}, 640, 360);
}

const Hierarchy& torus() {
  static const Hierarchy hierarchy = sampledHierarchy(scenes::rippledTorus(), 100'003);
  return hierarchy;
}

/// How often each leaf is covered by the nodes.
std::vector<int> coverOf(const Hierarchy& h, const std::vector<Index>& nodes) {
  std::vector<int> cover(h.leafCount(), 0);
  for (const Index node : nodes) {
    int level = 0;
    while (node >= h.levelBegin(level + 1)) ++level;
    const std::uint64_t inLevel = node - h.levelBegin(level), span = std::uint64_t{1} << (2 * level);
    const std::uint64_t end = std::min<std::uint64_t>((inLevel + 1) * span, h.leafCount());
    for (std::uint64_t leaf = inLevel * span; leaf < end; ++leaf) ++cover[leaf];
  }
  return cover;
}

TEST(Cut, TheMeanIsAsFineAsItsNumberOfNodesAllows) {
  EXPECT_FLOAT_EQ(tauOfMean(3, 0), 2);
  EXPECT_FLOAT_EQ(tauOfMean(3, 100'000), 2);
  EXPECT_FLOAT_EQ(tauOfMean(3, 100'000'000), 3);
  // The number of nodes goes with 1 / tau^2: any cut of a view leads to the same.
  EXPECT_NEAR(tauOfMean(3, 1'500'000), tauOfMean(6, 375'000), 1e-4);
  EXPECT_NEAR(tauOfMean(3, 1'500'000), tauOfMean(2, 3'375'000), 1e-4);
}

TEST(Cut, CoversEachLeafOnceWithoutCulling) {
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    for (const float zoom : {0.2f, 1.f, 5.f, 60.f}) {
      for (const float tau : {0.5f, 3.f, 20.f, 1e9f}) {
        const CutOptions options{.tau = tau, .cullFrustum = false, .cullBackfaces = false};
        const Cut cut = selectCut(torus(), torusView(zoom, projection), options);
        EXPECT_TRUE(cut.isComplete);
        EXPECT_EQ(cut.tau, tau);
        for (const int times : coverOf(torus(), cut.nodes)) ASSERT_EQ(times, 1) << zoom << " " << tau;
      }
    }
  }
}

TEST(Cut, CoversEachLeafInTheViewOnceAndNoLeafTwice) {
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    for (const float zoom : {1.f, 4.f, 30.f}) {
      const View view = torusView(zoom, projection);
      const Cut cut = selectCut(torus(), view, {.tau = 3});
      const std::vector<int> cover = coverOf(torus(), cut.nodes);
      for (Index leaf = 0; leaf < torus().leafCount(); ++leaf) {
        ASSERT_LE(cover[leaf], 1);
        const glm::vec3 p = view.toView(torus().splats()[leaf].center());
        if (p.z < view.nearDepth) continue;
        const glm::vec2 px = view.toPixels(p);
        const bool isInside = px.x >= 0 && px.y >= 0 && px.x < 640 && px.y < 360;
        if (isInside) {
          ASSERT_EQ(cover[leaf], 1) << leaf;
        }
      }
    }
  }
}

TEST(Cut, LeavesOutOnlyLeavesThatFaceAway) {
  Hierarchy sphere = sampledHierarchy(scenes::checkeredSphere(), 50'000);
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    const View view = frameView({{0, 0, 0}, 1}, {.projection = projection}, 400, 400);
    sphere.isClosedAndOriented = false;
    const std::size_t all = selectCut(sphere, view, {.tau = 3}).nodes.size();
    sphere.isClosedAndOriented = true;
    const Cut cut = selectCut(sphere, view, {.tau = 3});
    EXPECT_LT(static_cast<double>(cut.nodes.size()), 0.75 * static_cast<double>(all));
    const std::vector<int> cover = coverOf(sphere, cut.nodes);
    const glm::vec3 forward = view.toWorld({0, 0, 1}) - view.eye;
    for (Index leaf = 0; leaf < sphere.leafCount(); ++leaf) {
      const glm::vec3 p = sphere.splats()[leaf].center();
      const glm::vec3 towards = view.isPerspective() ? glm::normalize(view.eye - p) : -forward;
      if (glm::dot(glm::normalize(p), towards) > 0.01f) {
        ASSERT_EQ(cover[leaf], 1);
      }
    }
  }
}

TEST(Cut, IsFinerForASmallerTauAndNearlyEvenlySo) {
  std::size_t last = 0;
  for (const float tau : {12.f, 10.f, 8.f, 7.f, 6.f, 5.f, 4.f}) {
    const std::size_t count = selectCut(torus(), torusView(1), {.tau = tau}).nodes.size();
    EXPECT_GT(count, last);
    // One level to the next would be a factor of four at once; a quarter less tau asks for 1.8.
    if (last > 0) {
      EXPECT_LT(static_cast<double>(count), 2.2 * static_cast<double>(last)) << tau;
    }
    last = count;
  }
}

TEST(Cut, KeepsItsBudget) {
  for (const Index budget : {1u, 10u, 777u, 5000u, 60000u}) {
    for (const float zoom : {0.5f, 2.f, 50.f}) {
      const Cut cut = selectCut(torus(), torusView(zoom), {.tau = 0.5f, .budget = budget});
      EXPECT_LE(cut.nodes.size(), budget);
      EXPECT_EQ(cut.isComplete, cut.tau == 0.5f);
      CutMemory memory;
      EXPECT_LE(selectCut(torus(), torusView(zoom), {.tau = 0.5f, .budget = budget}, &memory).nodes.size(),
                budget);
    }
  }
}

TEST(Cut, IsTheSameForAnyNumberOfThreads) {
  CutMemory many, single;
  for (const float zoom : {1.f, 1.3f, 1.1f}) {
    const Cut onAll = selectCut(torus(), torusView(zoom), {.tau = 3}, &many);
    const ThreadLimit one(1);
    EXPECT_EQ(onAll.nodes, selectCut(torus(), torusView(zoom), {.tau = 3}, &single).nodes);
  }
}

/// Nodes of one list that are not in the other.
std::size_t strangers(std::vector<Index> a, std::vector<Index> b) {
  std::ranges::sort(a);
  std::ranges::sort(b);
  std::vector<Index> different;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(different));
  return different.size();
}

TEST(Cut, DoesNotFlickerWhenTheViewTrembles) {
  CutMemory memory;
  std::vector<Index> last = selectCut(torus(), torusView(1), {.tau = 4}, &memory).nodes;
  std::size_t withMemory = 0, without = 0;
  for (int frame = 0; frame < 10; ++frame) {
    // Less than the hysteresis of a tenth.
    const View view = torusView(frame % 2 ? 1.f : 1.03f);
    const std::vector<Index> nodes = selectCut(torus(), view, {.tau = 4}, &memory).nodes;
    if (frame > 0) withMemory += strangers(nodes, last);
    last = nodes;
    without += strangers(selectCut(torus(), torusView(1), {.tau = 4}).nodes,
                         selectCut(torus(), torusView(1.03f), {.tau = 4}).nodes);
  }
  EXPECT_EQ(withMemory, 0u);
  EXPECT_GT(without, 100u) << "the test sees flicker where there is no memory";
}

TEST(Cut, OfFewPoints) {
  for (const Index count : {0u, 1u, 3u, 5u}) {
    const Hierarchy h = sampledHierarchy(scenes::checkeredSphere(), count);
    const View view = frameView({{0, 0, 0}, 1}, {}, 100, 100);
    EXPECT_EQ(selectCut(h, view, {.tau = 1e-6f}).nodes.size(), count);
    EXPECT_LE(selectCut(h, view, {.tau = 1e9f}).nodes.size(), 1u);
  }
}

TEST(Cut, StopsWhenToldTo) {
  struct Stop final : Progress {
    bool cancelled() const override { return true; }
  } stop;
  EXPECT_THROW(selectCut(torus(), torusView(1), {}, nullptr, &stop), Cancelled);
}

}  // namespace
}  // namespace stipple
