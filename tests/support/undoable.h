#pragma once

#include <gtest/gtest.h>

#include "core/points/edit.h"
#include "plugins/api/operator.h"
#include "tests/support/identical.h"

namespace stipple {

/// The edit that leads to a result makes just that of the points, and is undone bit for bit.
inline void expectUndoable(const PointSet& before, const RunResult& result) {
  PointSet points = before;
  Edit edit = difference(before, result.points, result.removedRows);
  edit.apply(points);
  EXPECT_TRUE(identical(points, result.points));
  edit.revert(points);
  EXPECT_TRUE(identical(points, before));
}

}  // namespace stipple
