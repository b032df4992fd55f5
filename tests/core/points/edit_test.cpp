#include "core/points/edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "core/points/region.h"
#include "tests/support/identical.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

PointSet line(Index size) {
  std::vector<Eigen::Vector3f> positions(size);
  for (Index row = 0; row < size; ++row) positions[row] = {static_cast<float>(row), 0, 0};
  PointSet points(std::move(positions), {100, 200, 300}, ScalarType::kFloat64);
  std::vector<float> height(size);
  std::iota(height.begin(), height.end(), 10.f);
  points.set("height", height);
  points.set("color", std::vector<Rgba8>(size, Rgba8{1, 2, 3, 4}), {"", ScalarType::kUint8, true});
  points.setTriangles({{0, 1, 2}, {2, 3, 4}});
  return points;
}

// Applies and reverts the edit twice and expects the two states each time.
void expectLeadsThereAndBack(Edit edit, const PointSet& before, const PointSet& after) {
  PointSet points = before;
  for (int round = 0; round < 2; ++round) {
    edit.apply(points);
    EXPECT_TRUE(identical(points, after));
    edit.revert(points);
    EXPECT_TRUE(identical(points, before));
  }
}

TEST(Edit, OfTwoEqualStatesIsEmpty) {
  const PointSet before = line(6);
  PointSet after = before;
  EXPECT_TRUE(difference(before, after).empty());
  after.edit<float>("height")[3] = before.values<float>("height")[3];
  after.editPositions();
  after.setTriangles(before.triangles());
  EXPECT_TRUE(difference(before, after).empty());
  EXPECT_TRUE(difference(PointSet(), PointSet()).empty());
}

TEST(Edit, ChangesFewValues) {
  const PointSet before = line(1000);
  PointSet after = before;
  after.edit<float>("height")[3] = kNan;
  after.edit<Rgba8>("color")[999] = {9, 9, 9, 9};
  after.editPositions()[500].y() = -0.f;  // equal as a number, another bit pattern
  Edit edit = difference(before, after);
  EXPECT_FALSE(edit.empty());
  EXPECT_FALSE(edit.changesRows());
  EXPECT_LT(edit.memoryBytes(), 2000u) << "three rows of a thousand are held";
  expectLeadsThereAndBack(edit, before, after);
}

TEST(Edit, HoldsAColumnWholeWhereMostOfItChanged) {
  const PointSet before = line(1000);
  PointSet after = before;
  for (float& height : after.edit<float>("height")) height += 1;
  for (Eigen::Vector3f& position : after.editPositions()) position.z() = 1;
  const Edit edit = difference(before, after);
  EXPECT_GT(edit.memoryBytes(), 1000 * (sizeof(float) + sizeof(Eigen::Vector3f)));
  EXPECT_LT(edit.memoryBytes(), 1000 * (sizeof(float) + sizeof(Eigen::Vector3f)) + 2000);
  expectLeadsThereAndBack(edit, before, after);
}

TEST(Edit, NeverSharesAColumnWithTheSetItWasAppliedTo) {
  PointSet points = line(1000);
  Edit edit;
  {
    PointSet after = points;
    for (float& height : after.edit<float>("height")) height += 1;
    edit = difference(points, after);
  }
  edit.apply(points);
  const float* values = points.values<float>("height").data();
  points.edit<float>("height")[0] = 5;
  EXPECT_EQ(points.values<float>("height").data(), values) << "a write after the edit copied the column";
}

TEST(Edit, ReversesAddedRemovedRetypedAndReorderedAttributes) {
  PointSet before = line(6);
  before.set("a", std::vector<float>(6, 1));
  before.set("b", std::vector<float>(6, 2));
  PointSet after = before;
  after.erase("height");
  after.insert({"first", Column(std::vector<double>(6, 3)), {"first_in_file", ScalarType::kFloat64}}, 0);
  after.set("a", std::vector<std::int32_t>(6, 7));
  const Attribute color = *after.find("color");
  after.erase("color");
  after.insert(color);
  expectLeadsThereAndBack(difference(before, after), before, after);
}

TEST(Edit, ReversesTheFileProperty) {
  const PointSet before = line(6);
  PointSet after = before;
  after.find("color")->file.hasAlpha = false;
  after.find("height")->file = {"scalar_height", ScalarType::kInt16};
  const Edit edit = difference(before, after);
  EXPECT_FALSE(edit.empty());
  expectLeadsThereAndBack(edit, before, after);
}

TEST(Edit, ReversesTriangles) {
  const PointSet before = line(6);
  PointSet after = before;
  after.setTriangles({{5, 4, 3}});
  expectLeadsThereAndBack(difference(before, after), before, after);
}

TEST(Edit, RemovesAndAppendsRowsAndMapsThem) {
  PointSet points = line(6);
  const PointSet before = points;
  PointSet after = before;
  const std::vector<Index> removed = {0, 3};
  after.removeRows(removed);
  after.appendRows(PointSet({{7, 8, 9}}, before.origin()));
  after.edit<float>("height")[1] = -1;
  Edit edit = difference(before, after, removed);
  expectLeadsThereAndBack(edit, before, after);

  const auto rowsOf = [](const IndexMap& map, Index size) {
    std::vector<Index> rows(size);
    for (Index row = 0; row < size; ++row) rows[row] = map[row];
    return rows;
  };
  const IndexMap there = edit.apply(points);
  EXPECT_EQ(there.newSize(), 5u);
  EXPECT_THAT(rowsOf(there, 6), ElementsAre(IndexMap::kGone, 0, 1, IndexMap::kGone, 2, 3));
  const IndexMap back = edit.revert(points);
  EXPECT_EQ(back.newSize(), 6u);
  EXPECT_THAT(rowsOf(back, 5), ElementsAre(1, 2, 4, 5, IndexMap::kGone));
}

TEST(Edit, RemovesEveryRowAndBringsThemBack) {
  const PointSet before = line(6);
  PointSet after = before;
  const std::vector<Index> removed = {0, 1, 2, 3, 4, 5};
  after.removeRows(removed);
  expectLeadsThereAndBack(difference(before, after, removed), before, after);
}

TEST(Edit, GuardsRegionsByTheTopologyAndUndoMakesThemFitAgain) {
  PointSet points = line(6);
  const Region region = regionOfRows(points, std::vector<Index>{2});
  PointSet after = points;
  after.removeRows(std::vector<Index>{1});
  Edit edit = difference(points, after, std::vector<Index>{1});
  edit.apply(points);
  EXPECT_FALSE(region.fits(points));
  edit.revert(points);
  EXPECT_TRUE(region.fits(points));

  after = points;
  after.edit<float>("height")[0] = 0;
  Edit values = difference(points, after);
  EXPECT_TRUE(values.apply(points).isIdentity());
  EXPECT_TRUE(region.fits(points));
}

TEST(Edit, IsAValue) {
  const PointSet before = line(6);
  PointSet after = before;
  after.edit<float>("height")[2] = 5;
  Edit first = difference(before, after), second = first;
  PointSet points = before;
  first.apply(points);
  EXPECT_FALSE(second.isApplied());
  PointSet others = before;
  second.apply(others);
  EXPECT_TRUE(identical(others, after));
  first.revert(points);
  EXPECT_TRUE(identical(points, before));
  EXPECT_TRUE(identical(others, after));
}

TEST(Edit, RefusesASetThatDoesNotFitAndLeavesItAlone) {
  const PointSet before = line(6);
  PointSet after = before;
  after.edit<float>("height")[2] = 5;
  after.set("extra", std::vector<float>(6));
  Edit edit = difference(before, after);

  const auto expectRefused = [&edit](PointSet points, const std::string& sentence) {
    const PointSet untouched = points;
    try {
      edit.apply(points);
      ADD_FAILURE() << "accepted, expected: " << sentence;
    } catch (const InvalidInput& error) {
      EXPECT_EQ(error.what(), sentence);
    }
    EXPECT_TRUE(identical(points, untouched));
  };
  expectRefused(line(7), "the edit does not fit: the set has 7 points, expected 6");
  PointSet other = before;
  other.erase("height");
  expectRefused(other, "the edit does not fit: there is no attribute 'height'");
  other.set("height", std::vector<double>(6));
  expectRefused(other, "the edit does not fit: attribute 'height' is of type double, expected float");
  expectRefused(after, "the edit does not fit: there is an attribute 'extra' already");
  PointSet points = before;
  EXPECT_THROW(edit.revert(points), InvalidInput);
  edit.apply(points);
  EXPECT_THROW(edit.apply(points), InvalidInput);
  EXPECT_TRUE(identical(points, after));
}

TEST(Edit, WithRowsRefusesAnAttributeItDoesNotKnow) {
  const PointSet before = line(6);
  PointSet after = before;
  after.appendRows(PointSet({{7, 8, 9}}, before.origin()));
  Edit edit = difference(before, after);
  PointSet other = before;
  other.set("new", std::vector<float>(6));
  EXPECT_THROW(edit.apply(other), InvalidInput);
}

TEST(Difference, RefusesStatesThatDoNotFit) {
  const PointSet before = line(6);
  EXPECT_THROW(difference(before, line(5)), InvalidInput);
  EXPECT_THROW(difference(before, before, std::vector<Index>{6}), InvalidInput);
  EXPECT_THROW(difference(before, before, std::vector<Index>{2, 1}), InvalidInput);
  EXPECT_THROW(difference(PointSet({{0, 0, 0}}), PointSet({{0, 0, 0}}, {1, 0, 0})), InvalidInput);
}

TEST(Edit, TellsWhichColumnsItTouches) {
  const PointSet before = line(40);
  PointSet after = before;
  after.edit<float>("height")[7] = 1;
  after.erase("color");
  after.set("curvature", std::vector<float>(40, 1));
  Edit edit = difference(before, after);
  const auto check = [&] {
    const auto touched = edit.touched();
    ASSERT_EQ(touched.size(), 3u);
    EXPECT_EQ(touched[0].name, "height");
    EXPECT_THAT(*touched[0].rows, ElementsAre(7));
    std::vector<std::string> whole = {touched[1].name, touched[2].name};
    EXPECT_THAT(whole, UnorderedElementsAre("color", "curvature"));
    EXPECT_EQ(touched[1].rows, nullptr);
    EXPECT_FALSE(edit.changesTriangles());
  };
  check();
  PointSet points = before;
  edit.apply(points);
  check();
  EXPECT_TRUE(difference(before, before).touched().empty());
}

}  // namespace
}  // namespace stipple
