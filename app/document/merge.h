#pragma once

#include "core/points/edit.h"
#include "plugins/api/operator.h"

namespace stipple {

/// What a run made of the points that it was started on.
struct FinishedRun {
  PointSet snapshot = {};
  RunResult result = {};
  Edit edit = {};  ///< from the snapshot to the result
  Report report = {};
};

struct MergedRun {
  Edit edit;             ///< from the points as they are now
  Index keptByUser = 0;  ///< points with a value of the user's where the run had another
};

/// The result of a run against points that may have been painted on since the snapshot: wherever the result
/// differs from the snapshot it is taken, except for values that differ from the snapshot now. O(rows) for
/// each column that both changed, otherwise O(1). Throws InvalidInput where rows came or went since.
MergedRun mergeRun(const FinishedRun& run, const PointSet& now);

}  // namespace stipple
