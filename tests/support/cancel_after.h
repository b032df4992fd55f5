#pragma once

#include <atomic>

#include "core/progress.h"

/// Yes to cancel from the first question, or from the one after `patience` answers, whichever thread asks.
class CancelAfter final : public stipple::Progress {
 public:
  explicit CancelAfter(int patience) : patience_(patience) {}
  bool cancelled() const override { return asked_++ >= patience_; }

 private:
  int patience_;
  mutable std::atomic<int> asked_ = 0;
};
