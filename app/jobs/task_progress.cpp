#include "app/jobs/task_progress.h"

#include <utility>

namespace stipple {

namespace {

// Before these a guess would be wrong by a multiple.
constexpr double kLeastFraction = 0.02;
constexpr double kLeastSeconds = 0.5;

}  // namespace

void TaskProgress::report(double fraction, std::string_view message) {
  const std::lock_guard lock(mutex_);
  fraction_ = fraction;
  message_ = message;
}

void TaskProgress::publish(const PointSet& state) {
  const std::lock_guard lock(mutex_);
  preview_ = state;
}

double TaskProgress::secondsWorked() const {
  const Clock::duration spell = since_ ? Clock::now() - *since_ : Clock::duration(0);
  return std::chrono::duration<double>(worked_ + spell).count();
}

TaskStatus TaskProgress::status() const {
  const std::lock_guard lock(mutex_);
  TaskStatus status{.fraction = fraction_, .message = message_, .seconds = secondsWorked()};
  if (fraction_ >= kLeastFraction && status.seconds >= kLeastSeconds) {
    status.secondsLeft = status.seconds * (1 - fraction_) / fraction_;
  }
  return status;
}

std::optional<PointSet> TaskProgress::takePreview() {
  const std::lock_guard lock(mutex_);
  return std::exchange(preview_, std::nullopt);
}

bool TaskProgress::hasPreview() const {
  const std::lock_guard lock(mutex_);
  return preview_.has_value();
}

void TaskProgress::work() {
  const std::lock_guard lock(mutex_);
  if (!since_) since_ = Clock::now();
}

void TaskProgress::rest() {
  const std::lock_guard lock(mutex_);
  if (since_) worked_ += Clock::now() - *since_;
  since_.reset();
}

}  // namespace stipple
