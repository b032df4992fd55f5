#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "core/points/point_set.h"
#include "core/progress.h"

namespace stipple {

/// How far a task is.
struct TaskStatus {
  double fraction = 0;
  std::string message = {};
  double seconds = 0;                      ///< that it has worked
  std::optional<double> secondsLeft = {};  ///< once that can be told
};

/// What a worker reports and its owner asks, on two threads.
class TaskProgress final : public Progress {
 public:
  void report(double fraction, std::string_view message) override;
  void publish(const PointSet& state) override;
  bool cancelled() const override { return cancelled_; }

  void cancel() { cancelled_ = true; }
  TaskStatus status() const;
  /// The latest intermediate state since the last call.
  std::optional<PointSet> takePreview();
  bool hasPreview() const;
  /// The clock stands while nothing is done.
  void work();
  void rest();

 private:
  using Clock = std::chrono::steady_clock;
  double secondsWorked() const;

  std::atomic<bool> cancelled_ = false;
  mutable std::mutex mutex_;
  double fraction_ = 0;
  std::string message_;
  std::optional<PointSet> preview_;
  Clock::duration worked_{0};                              // in earlier spells
  std::optional<Clock::time_point> since_ = Clock::now();  // none: it rests
};

}  // namespace stipple
