#pragma once

#include <memory>

#include "plugins/api/operator.h"

namespace stipple {

/// An operator could not do its work, or broke the rules of its interface; the message begins with its id.
class OperatorFailure : public Error {
 public:
  using Error::Error;
};

/// Starts an operator behind the plugin border: of everything that the operator or its run throws, then or in
/// a later call, only Cancelled and OperatorFailure come out. Results that contradict the snapshot are
/// failures too.
std::unique_ptr<Run> startGuarded(const Operator& op, const PointSet& snapshot, const Region& region,
                                  const Parameters& parameters);

}  // namespace stipple
