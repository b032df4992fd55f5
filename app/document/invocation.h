#pragma once

#include <memory>
#include <string>

#include "plugins/api/registry.h"

namespace stipple {

/// The user asked for something that does not exist or is out of range: an operator, a value, a region.
class UsageError : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
};

/// One use of an operator: what the window, the command line, a line of a recipe and a test have in common.
struct Invocation {
  std::string operatorId;
  Parameters parameters;
  std::string region = {};  ///< an attribute; the region is where it is not 0. Empty: everything
};

struct InvocationResult {
  RunResult result;
  Report report;
  int steps = 0;
};

/// The operator at its defaults. Throws UsageError, naming the operators there are, where it is unknown.
Invocation makeInvocation(const Registry& registry, const std::string& operatorId);

/// Starts the operator behind the plugin border. Throws UsageError where the region or an attribute named by
/// a parameter is not in the points, or an operator that needs a region has none; OperatorFailure.
std::unique_ptr<Run> startInvocation(const Registry& registry, const Invocation& invocation,
                                     const PointSet& points);

/// Steps the operator on `points` until it is finished. Throws as startInvocation, and Cancelled.
InvocationResult invoke(const Registry& registry, const Invocation& invocation, const PointSet& points,
                        Progress& progress);

}  // namespace stipple
