#include "core/points/edit_file.h"

#include <gtest/gtest.h>

#include "tests/support/identical.h"
#include "tests/support/random_actions.h"

namespace stipple {
namespace {

// A random edit between two states.
struct Step {
  PointSet before, after;
  Edit edit;
};

Step randomStep(RandomActions& actions, const PointSet& points) {
  Step step{.before = points, .after = {}, .edit = {}};
  std::vector<Index> removed;
  step.after = actions.changed(points, removed);
  step.edit = difference(points, step.after, removed);
  return step;
}

PointSet somePoints() {
  PointSet points(std::vector<Eigen::Vector3f>(40, Eigen::Vector3f(1, 2, 3)), {4, 5, 6});
  points.set("a", std::vector<float>(40, 7), {.name = "red", .type = ScalarType::kUint8});
  points.set("b", std::vector<Rgba8>(40, Rgba8{1, 2, 3, 4}), {.name = "", .hasAlpha = true});
  points.setTriangles({{0, 1, 2}, {37, 38, 39}});
  return points;
}

// Applies and reverts what a set can take; anything else must be refused with a sentence.
void tryOn(PointSet points, Edit edit) {
  try {
    edit.isApplied() ? edit.revert(points) : edit.apply(points);
    edit.isApplied() ? edit.revert(points) : edit.apply(points);
  } catch (const InvalidInput&) {
  }
}

TEST(EditFile, LeadsBetweenTheSameStatesBitForBit) {
  RandomActions actions(3);
  PointSet points = somePoints();
  for (int i = 0; i < 300; ++i) {
    Step step = randomStep(actions, points);
    Edit edit = parseEdit(formatEdit(step.edit), EditWriter::kThisProgram);
    PointSet current = step.before;
    edit.apply(current);
    ASSERT_TRUE(identical(current, step.after)) << i;
    edit = parseEdit(formatEdit(edit), EditWriter::kThisProgram);
    ASSERT_TRUE(edit.isApplied());
    edit.revert(current);
    ASSERT_TRUE(identical(current, step.before)) << i;
    ASSERT_EQ(current.topologyId(), step.before.topologyId()) << i;
    points = step.after;
    if (points.size() > 400) points = somePoints();
  }
}

TEST(EditFile, AnotherProgramKnowsNothingOfOurTopologies) {
  PointSet points = somePoints(), fewer = points;
  const std::vector<Index> removed = {3, 4};
  fewer.removeRows(removed);
  const auto bytes = formatEdit(difference(points, fewer, removed));
  PointSet here = points, there = points;
  parseEdit(bytes, EditWriter::kThisProgram).apply(here);
  parseEdit(bytes, EditWriter::kAnotherProgram).apply(there);
  EXPECT_TRUE(identical(here, there));
  EXPECT_NE(here.topologyId(), there.topologyId());
}

TEST(EditFile, EveryTruncationIsRefused) {
  RandomActions actions(5);
  for (int i = 0; i < 20; ++i) {
    const auto bytes = formatEdit(randomStep(actions, somePoints()).edit);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      ASSERT_THROW(parseEdit(std::span(bytes).first(length), EditWriter::kThisProgram), InvalidInput)
          << length;
    }
    auto longer = bytes;
    longer.push_back({});
    ASSERT_THROW(parseEdit(longer, EditWriter::kThisProgram), InvalidInput);
  }
}

TEST(EditFile, FlippedBytesDoNoHarm) {
  RandomActions actions(7);
  for (int i = 0; i < 20; ++i) {
    const Step step = randomStep(actions, somePoints());
    Edit applied = step.edit;
    PointSet after = step.before;
    applied.apply(after);
    for (const Edit& edit : {step.edit, applied}) {
      const auto bytes = formatEdit(edit);
      // Everything at the front, where counts and kinds stand, then some of the values.
      for (std::size_t at = 0; at < bytes.size(); at += at < 300 ? 1 : 1 + actions.below(60)) {
        for (const int flip : {0x01, 0x80, 0xff}) {
          auto flipped = bytes;
          flipped[at] ^= static_cast<std::byte>(flip);
          try {
            tryOn(edit.isApplied() ? after : step.before, parseEdit(flipped, EditWriter::kThisProgram));
          } catch (const InvalidInput&) {
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace stipple
