#include "app/view/display_follower.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "app/view/displayed_surface.h"
#include "tests/app/view/shown_points.h"
#include "tests/support/sampled_hierarchy.h"

namespace stipple {
namespace {

// What a view does with changes, without pictures.
struct Shown {
  DisplayedSurface surface;

  void take(const SceneChange& change) {
    if (const auto* fresh = std::get_if<NewSurface>(&change)) {
      surface = DisplayedSurface(fresh->points, fresh->colors.of(fresh->points), nullptr);
    } else if (const auto* restate = std::get_if<Restate>(&change)) {
      surface.recolorAll(restate->colors.of(restate->points));
      if (restate->moved) surface.move(restate->points);
    } else if (const auto* recolor = std::get_if<Recolor>(&change)) {
      surface.recolor(recolor->rows, recolor->colors);
    }
  }
};

// Every node is what a fresh aggregation of the leaves makes of it.
bool isFreshlyAggregated(const DisplayedSurface& surface) {
  const Hierarchy& shown = surface.hierarchy();
  Hierarchy fresh(shown.leafCount());
  fresh.pointOfSlot.resize(shown.leafCount());
  fresh.slotOfPoint.resize(shown.leafCount());
  for (Index slot = 0; slot < shown.leafCount(); ++slot) {
    fresh.pointOfSlot[slot] = shown.pointOfSlot[slot];
    fresh.slotOfPoint[slot] = shown.slotOfPoint[slot];
    fresh.editSplats()[slot] = shown.splats()[slot];
  }
  refitAll(fresh);
  return sameNodes(shown, fresh);
}

std::vector<Rgba8> leafColors(const DisplayedSurface& surface) {
  std::vector<Rgba8> colors(surface.size());
  for (Index point = 0; point < surface.size(); ++point)
    colors[point] = surface.hierarchy().splats()[surface.hierarchy().slotOfPoint[point]].color;
  return colors;
}

class DisplayFollowing : public testing::Test {
 protected:
  void begin(const Look& look) { shown.take(follower.show(document.points(), look)); }
  void follow() {
    if (const auto change = follower.follow(document.points(), document.changedSince(seen))) {
      shown.take(*change);
      kind = change->index();
    }
    seen = document.revision();
  }
  void commit(const PointSet& after) {
    seen = document.revision();
    document.commit("change", difference(document.points(), after));
    follow();
  }
  void expectShownAsIs(const Look& look) {
    ColorSource source = look.colors;
    if (document.points().has("selection")) source.selection = "selection";
    EXPECT_EQ(leafColors(shown.surface), colorPoints(document.points(), source));
    EXPECT_TRUE(isFreshlyAggregated(shown.surface));
  }

  Document document{shownSphere(5000), "sphere.ply"};
  DisplayFollower follower;
  Shown shown;
  std::uint64_t seen = document.revision();
  std::size_t kind = 99;
};

TEST_F(DisplayFollowing, FewPaintedRowsAreRecoloredAlone) {
  begin({});
  PointSet after = document.points();
  for (Index row = 100; row < 200; ++row) after.edit<Rgba8>("color")[row] = {255, 0, 0, 255};
  commit(after);
  EXPECT_EQ(kind, SceneChange(Recolor{}).index());
  expectShownAsIs({});
}

TEST_F(DisplayFollowing, OperatorsAndUndoReachTheInnerNodes) {
  const Look look{.colors = {.attribute = "label"}};
  begin(look);
  PointSet after = document.points();
  for (std::int32_t& label : after.edit<std::int32_t>("label")) label += 3;
  commit(after);
  expectShownAsIs(look);
  document.undo();
  follow();
  expectShownAsIs(look);
}

TEST_F(DisplayFollowing, MovedPointsMoveTheirNodes) {
  begin({});
  PointSet after = document.points();
  for (Eigen::Vector3f& p : after.editPositions()) p *= 1.5f;
  commit(after);
  const Splat& root = shown.surface.hierarchy().splats().back();
  EXPECT_LT(glm::length(root.center()), 0.1f);
  EXPECT_GT(shown.surface.hierarchy().bound(shown.surface.hierarchy().nodeCount() - 1).radius, 1.4f);
  expectShownAsIs({});
}

TEST_F(DisplayFollowing, OtherTrianglesAreShownWhereTrianglesAre) {
  PointSet after = document.points();
  after.setTriangles({{0, 1, 2}});
  for (const bool asMesh : {false, true}) {
    begin({.asMesh = asMesh});
    seen = document.revision();
    document.commit("triangulate", difference(document.points(), after));
    const auto change = follower.follow(document.points(), document.changedSince(seen));
    EXPECT_EQ(change.has_value(), asMesh);
    if (change) {
      EXPECT_EQ(std::get<Restate>(*change).points.triangles().size(), 1u);
    }
    document.undo();
  }
}

TEST_F(DisplayFollowing, RemovedPointsAreANewSurface) {
  begin({});
  PointSet after = document.points();
  const std::vector<Index> rows{0, 5, 9};
  after.removeRows(rows);
  document.commit("remove", difference(document.points(), after, rows));
  follow();
  EXPECT_EQ(shown.surface.size(), 4997u);
  expectShownAsIs({});
}

TEST_F(DisplayFollowing, SelectionAndWhatIsNotShown) {
  begin({});
  PointSet after = document.points();
  std::vector<std::int32_t> selection(after.size(), 0);
  selection[7] = 1;
  after.set("selection", selection);
  commit(after);
  expectShownAsIs({});
  kind = 99;
  after.edit<float>("height")[3] = 9;
  commit(after);
  EXPECT_EQ(kind, 99u) << "heights are not shown";
}

TEST_F(DisplayFollowing, AnAttributeThatIsGoneGivesWayToColors) {
  const Look look{.colors = {.attribute = "height"}};
  begin(look);
  PointSet after = document.points();
  after.erase("height");
  commit(after);
  expectShownAsIs({});
  document.undo();
  follow();
  expectShownAsIs(look);
}

TEST_F(DisplayFollowing, AnyRowOfActionsEndsAsFreshlyShown) {
  const Look look{.colors = {.attribute = "label"}};
  begin(look);
  std::mt19937 random(3);
  for (int action = 0; action < 60; ++action) {
    PointSet after = document.points();
    const Index first = random() % (after.size() - 50);
    switch (random() % 5) {
      case 0:
        for (Index row = first; row < first + 50; ++row) after.edit<std::int32_t>("label")[row] = 7;
        break;
      case 1:
        for (Index row = first; row < first + 50; ++row) after.editPositions()[row] *= 1.01f;
        break;
      case 2:
        document.undo();
        follow();
        continue;
      case 3:
        document.redo();
        follow();
        continue;
      default:
        for (std::int32_t& label : after.edit<std::int32_t>("label")) label = 1 + (label + 1) % 5;
    }
    commit(after);
  }
  expectShownAsIs(look);
}

}  // namespace
}  // namespace stipple
