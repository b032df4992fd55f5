#include "app/tools/selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

PointSet fivePoints() {
  return PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
}

TEST(Selection, IsAnAttributeOfThePoints) {
  const PointSet points = fivePoints();
  EXPECT_THAT(selectionOf(points), ElementsAre(0, 0, 0, 0, 0));
  const SelectionMask mask{0, 1, 0, 1, 1};
  const PointSet selected = withSelection(points, mask);
  EXPECT_THAT(selected.values<std::int32_t>("selection"), ElementsAre(0, 1, 0, 1, 1));
  EXPECT_EQ(selectionOf(selected), mask);
  EXPECT_FALSE(points.has("selection"));
  EXPECT_FALSE(withSelection(selected, nothing(5)).has("selection"));
  EXPECT_THROW(withSelection(points, nothing(4)), InvalidInput);
}

TEST(Selection, IsReadFromAnyTypeThatAFileHas) {
  PointSet points = fivePoints();
  points.set("selection", std::vector<float>{0, 0.5f, 0, 1, 0});
  EXPECT_THAT(selectionOf(points), ElementsAre(0, 1, 0, 1, 0));
}

TEST(Selection, CombinesWithNewRows) {
  const SelectionMask old{1, 1, 0, 0, 0};
  const std::vector<Index> rows{1, 2};
  EXPECT_THAT(combine(old, rows, Combine::kReplace), ElementsAre(0, 1, 1, 0, 0));
  EXPECT_THAT(combine(old, rows, Combine::kAdd), ElementsAre(1, 1, 1, 0, 0));
  EXPECT_THAT(combine(old, rows, Combine::kRemove), ElementsAre(1, 0, 0, 0, 0));
  EXPECT_EQ(combineFor({}), Combine::kReplace);
  EXPECT_EQ(combineFor({.shift = true}), Combine::kAdd);
  EXPECT_EQ(combineFor({.ctrl = true}), Combine::kRemove);
}

TEST(Selection, InvertsAndCounts) {
  EXPECT_THAT(invert({1, 0, 0}), ElementsAre(0, 1, 1));
  EXPECT_EQ(invert(everything(3)), nothing(3));
  EXPECT_EQ(countSelected(SelectionMask{1, 0, 1}), 2u);
}

TEST(Selection, FindsValuesInARange) {
  PointSet points = fivePoints();
  points.set("height", std::vector<float>{0, 1, std::numeric_limits<float>::quiet_NaN(), 2, 3});
  points.set("label", std::vector<std::int32_t>{5, -1, 5, 7, 5});
  points.set("color", std::vector<Rgba8>(5));
  EXPECT_THAT(findInRange(points, "height", 1, 2), ElementsAre(1, 3));
  EXPECT_THAT(findInRange(points, "label", 5, 5), ElementsAre(0, 2, 4));
  EXPECT_THAT(findInRange(points, "label", 6, 5), IsEmpty());
  EXPECT_THROW(findInRange(points, "color", 0, 1), InvalidInput);
  EXPECT_THROW(findInRange(points, "none", 0, 1), InvalidInput);
}

TEST(Selection, StoresAndRecallsByName) {
  const PointSet selected = withSelection(fivePoints(), SelectionMask{0, 1, 1, 0, 0});
  const PointSet stored = storeSelection(selected, "left_ear");
  EXPECT_TRUE(stored.has("selection_left_ear"));
  EXPECT_THAT(storedSelections(stored), ElementsAre("left_ear"));
  const PointSet other = withSelection(stored, SelectionMask{1, 0, 0, 0, 0});
  EXPECT_THAT(selectionOf(recallSelection(other, "left_ear")), ElementsAre(0, 1, 1, 0, 0));
  EXPECT_THAT(storedSelections(forgetSelection(stored, "left_ear")), IsEmpty());
  EXPECT_THROW(storeSelection(fivePoints(), "a"), InvalidInput) << "nothing is selected";
  EXPECT_THROW(storeSelection(selected, ""), InvalidInput);
  EXPECT_THROW(storeSelection(selected, "left ear"), InvalidInput);
  EXPECT_THROW(recallSelection(selected, "a"), InvalidInput);
  EXPECT_THROW(forgetSelection(selected, "a"), InvalidInput);
}

}  // namespace
}  // namespace stipple
