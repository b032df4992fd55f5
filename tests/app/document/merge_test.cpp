#include "app/document/merge.h"

#include <gmock/gmock.h>

#include "tests/support/identical.h"
#include "tests/support/random_actions.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

using Labels = std::vector<std::int32_t>;

PointSet fourPoints() {
  PointSet points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  points.set("label", Labels{0, 0, 0, 0});
  points.set("color", std::vector<Rgba8>(4, Rgba8{1, 2, 3, 255}));
  return points;
}

FinishedRun runFrom(const PointSet& snapshot, PointSet result, std::vector<Index> removed = {}) {
  FinishedRun run{.snapshot = snapshot, .result = {std::move(result), std::move(removed)}};
  run.edit = difference(run.snapshot, run.result.points, run.result.removedRows);
  return run;
}

struct Merged {
  PointSet points;
  Index kept;
};

Merged merge(const FinishedRun& run, PointSet now) {
  MergedRun merged = mergeRun(run, now);
  const PointSet before = now;
  merged.edit.apply(now);
  const PointSet after = now;
  merged.edit.revert(now);
  EXPECT_TRUE(identical(now, before));
  return {after, merged.keptByUser};
}

TEST(Merge, TakesTheResultWhereNothingHappenedSince) {
  RandomActions actions(9);
  PointSet points = fourPoints();
  for (int i = 0; i < 200; ++i) {
    std::vector<Index> removed;
    const PointSet result = actions.changed(points, removed);
    const FinishedRun run = runFrom(points, result, removed);
    const Merged merged = merge(run, points);
    ASSERT_TRUE(identical(merged.points, result));
    ASSERT_EQ(merged.kept, 0u);
    points = result.size() > 500 ? fourPoints() : result;
  }
}

TEST(Merge, PointsThatTheUserTouchedKeepTheirValue) {
  const PointSet snapshot = fourPoints();
  PointSet result = snapshot, now = snapshot;
  result.set("label", Labels{5, 5, 5, 0});
  result.editPositions()[1].z() = 1;
  now.set("label", Labels{0, 7, 5, 7});
  now.edit<Rgba8>("color")[0] = {9, 9, 9, 255};
  const Merged merged = merge(runFrom(snapshot, result), now);
  EXPECT_THAT(merged.points.values<std::int32_t>("label"), ElementsAre(5, 7, 5, 7));
  EXPECT_EQ(merged.kept, 1u) << "what both made the same is no conflict, nor what the run left alone";
  EXPECT_EQ(merged.points.positions()[1].z(), 1);
  EXPECT_EQ(merged.points.values<Rgba8>("color")[0], (Rgba8{9, 9, 9, 255}));
}

TEST(Merge, AttributesThatBothMadeBeganEmpty) {
  const PointSet snapshot = fourPoints();
  PointSet result = snapshot, now = snapshot;
  result.set("segment", Labels{1, 1, 2, 2});
  result.set("heat", std::vector<float>{1, 2, 3, 4});
  now.set("segment", Labels{0, 9, 0, 0});
  const Merged merged = merge(runFrom(snapshot, result), now);
  EXPECT_THAT(merged.points.values<std::int32_t>("segment"), ElementsAre(1, 9, 2, 2));
  EXPECT_THAT(merged.points.values<float>("heat"), ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(merged.kept, 1u);
  now.set("segment", std::vector<float>{0, 9, 0, 0});
  const Merged other = merge(runFrom(snapshot, result), now);
  EXPECT_THAT(other.points.values<float>("segment"), ElementsAre(0, 9, 0, 0));
  EXPECT_EQ(other.kept, 4u);
}

TEST(Merge, AttributesThatOneErasedOrRetyped) {
  const PointSet snapshot = fourPoints();
  PointSet erased = snapshot, painted = snapshot, retyped = snapshot;
  erased.erase("label");
  painted.set("label", Labels{0, 3, 0, 0});
  retyped.set("label", std::vector<float>{1, 2, 3, 4});
  PointSet aside = snapshot;
  aside.set("aside", Labels{1, 1, 1, 1});

  EXPECT_FALSE(merge(runFrom(snapshot, erased), aside).points.has("label"));
  const Merged kept = merge(runFrom(snapshot, erased), painted);
  EXPECT_THAT(kept.points.values<std::int32_t>("label"), ElementsAre(0, 3, 0, 0));
  EXPECT_EQ(kept.kept, 1u);
  const Merged gone = merge(runFrom(snapshot, painted), erased);
  EXPECT_FALSE(gone.points.has("label"));
  EXPECT_EQ(gone.kept, 1u);
  EXPECT_THAT(merge(runFrom(snapshot, retyped), aside).points.values<float>("label"),
              ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(merge(runFrom(snapshot, retyped), painted).kept, 1u);
  EXPECT_EQ(merge(runFrom(snapshot, painted), retyped).kept, 1u);
}

TEST(Merge, RowsOfTheRunGoAndComeUnderTheBrush) {
  const PointSet snapshot = fourPoints();
  PointSet result = snapshot, now = snapshot;
  result.removeRows(std::vector<Index>{1});
  result.set("label", Labels{4, 4, 4});
  PointSet more({{9, 9, 9}});
  more.set("label", Labels{6});
  result.appendRows(more);
  result.setTriangles({{0, 1, 3}});
  now.set("label", Labels{0, 8, 8, 0});
  now.set("mask", Labels{1, 2, 3, 4});
  const Merged merged = merge(runFrom(snapshot, result, {1}), now);
  EXPECT_THAT(merged.points.values<std::int32_t>("label"), ElementsAre(4, 8, 4, 6));
  EXPECT_THAT(merged.points.values<std::int32_t>("mask"), ElementsAre(1, 3, 4, 0));
  EXPECT_EQ(merged.points.positions()[3].x(), 9);
  EXPECT_EQ(merged.points.triangles().size(), 1u);
  EXPECT_EQ(merged.kept, 1u);
}

TEST(Merge, RefusesOtherRows) {
  const PointSet snapshot = fourPoints();
  PointSet result = snapshot, now = snapshot;
  result.set("label", Labels{1, 1, 1, 1});
  now.removeRows(std::vector<Index>{0});
  EXPECT_THAT([&] { mergeRun(runFrom(snapshot, result), now); },
              ThrowsMessage<InvalidInput>(HasSubstr("added or removed")));
}

}  // namespace
}  // namespace stipple
