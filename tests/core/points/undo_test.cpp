#include <gtest/gtest.h>

#include "core/points/edit.h"
#include "tests/support/identical.h"
#include "tests/support/random_actions.h"

namespace stipple {
namespace {

// The rows are also known to be the same rows, so that regions fit again.
bool sameState(const PointSet& a, const PointSet& b) {
  return identical(a, b) && a.topologyId() == b.topologyId();
}

TEST(Undo, IsIdentityOverAThousandRandomActions) {
  RandomActions actions(7);
  PointSet points(std::vector<Eigen::Vector3f>(300, Eigen::Vector3f::Zero()), {1, 2, 3});
  std::vector<PointSet> states = {points};
  std::vector<Edit> edits;
  std::size_t done = 0;  // edits below it are applied
  for (int action = 0; action < 1000; ++action) {
    // Wander back and forth through what was done, then do something new.
    const std::size_t target = edits.size() - std::min<std::size_t>(edits.size(), actions.below(4));
    for (; done > target; --done) {
      edits[done - 1].revert(points);
      ASSERT_TRUE(sameState(points, states[done - 1]))
          << "undo of edit " << done - 1 << " at action " << action;
    }
    for (; done < edits.size() && actions.below(3) != 0; ++done) {
      edits[done].apply(points);
      ASSERT_TRUE(sameState(points, states[done + 1])) << "redo of edit " << done << " at action " << action;
    }
    edits.resize(done);
    states.resize(done + 1);
    std::vector<Index> removed;
    const PointSet next = actions.changed(points, removed);
    Edit edit = difference(points, next, removed);
    edit.apply(points);
    ASSERT_TRUE(identical(points, next)) << "action " << action;
    edits.push_back(std::move(edit));
    states.push_back(points);
    ++done;
  }
  EXPECT_GT(edits.size(), 100u);
  while (done > 0) {
    edits[--done].revert(points);
    ASSERT_TRUE(sameState(points, states[done])) << "undo of edit " << done << " at the end";
  }
}

}  // namespace
}  // namespace stipple
