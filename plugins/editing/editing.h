#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// The standard tools that prepare a scan. Those that remove points keep the order of the rest.
std::unique_ptr<Operator> makeDeletePoints();
std::unique_ptr<Operator> makeCrop();
std::unique_ptr<Operator> makeRemoveOutliers();
std::unique_ptr<Operator> makeResample();
std::unique_ptr<Operator> makeEstimateNormals();
std::unique_ptr<Operator> makeFlipNormals();
std::unique_ptr<Operator> makeTransferAttributes();

/// The points without these rows (ascending); how many went is reported as `removed`. Throws InvalidInput
/// where nothing would be left.
RunResult withoutRows(const PointSet& points, std::vector<Index> rows, Report& report);

}  // namespace stipple
