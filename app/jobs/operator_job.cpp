#include "app/jobs/operator_job.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace stipple {

namespace {

// Puts the fractions of a step in their place within the run, and notes whether a state was published.
class StepProgress final : public Progress {
 public:
  StepProgress(Progress& run, double begin, double share) : run_(run), begin_(begin), share_(share) {}
  void report(double fraction, std::string_view message) override {
    run_.report(begin_ + share_ * fraction, message);
  }
  void publish(const PointSet& state) override {
    run_.publish(state);
    hasPublished_ = true;
  }
  bool cancelled() const override { return run_.cancelled(); }
  bool hasPublished() const { return hasPublished_; }

 private:
  Progress& run_;
  double begin_, share_;
  bool hasPublished_ = false;
};

}  // namespace

// What the owner and the worker share; it outlives the one that ends first.
struct OperatorJob::Shared {
  // Only the worker touches these.
  std::shared_ptr<const Registry> registry;
  Invocation invocation;
  PointSet snapshot;
  std::unique_ptr<Run> run = {};
  double fraction = 0, lastShare = 1;

  TaskProgress progress = {};
  mutable std::mutex mutex = {};
  std::condition_variable ordered = {};
  // The owner's orders.
  bool isPaused = false, isStopped = false;
  int stepsAsked = 0;
  std::optional<Parameters> parameters = {};
  // What the worker has to say. No state: it works or waits for orders.
  std::optional<JobState> ended = {};
  bool inStep = false;
  int steps = 0;
  std::vector<double> curve = {};
  std::optional<FinishedRun> result = {};
  std::string failure = {};
  std::string title = {};

  enum class Order { kStep, kFinish, kEnd };

  template <class Give>
  void order(Give&& give) {
    const std::lock_guard lock(mutex);
    give();
    ordered.notify_all();
  }
  /// It has finished, but parameters that were set since are still to act. Under the mutex.
  bool goesOn() const { return ended == JobState::kFinished && parameters && !isStopped; }
  void work();
  Order waitForOrder();
  void step();
  void prepareStep();
  void offerPreview(const StepProgress& step);
  void finish();
};

void OperatorJob::Shared::work() {
  JobState end = JobState::kCancelled;
  std::string sentence;
  try {
    for (Order order = waitForOrder(); order != Order::kEnd; order = waitForOrder()) {
      order == Order::kStep ? step() : finish();
    }
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    end = JobState::kFailed;
    sentence = error.what();
  }
  progress.rest();
  run.reset();
  const std::lock_guard lock(mutex);
  inStep = false;
  failure = std::move(sentence);
  if (!(ended && isStopped)) ended = end;
}

OperatorJob::Shared::Order OperatorJob::Shared::waitForOrder() {
  std::unique_lock lock(mutex);
  const auto hasOrder = [this] {
    if (progress.cancelled() || isStopped) return true;
    return ended ? parameters.has_value() : !isPaused || stepsAsked > 0;
  };
  if (!hasOrder()) progress.rest();
  ordered.wait(lock, hasOrder);
  progress.work();
  if (progress.cancelled() || (ended && isStopped)) return Order::kEnd;
  if (isStopped) return Order::kFinish;
  // A finished run that was set again does a step though it be paused.
  if (isPaused && !(ended && stepsAsked == 0)) --stepsAsked;
  if (ended) result.reset();
  ended.reset();
  inStep = true;
  return Order::kStep;
}

// Starts the run with its first step, so that nothing is computed for a job that is only prepared.
void OperatorJob::Shared::prepareStep() {
  std::optional<Parameters> given;
  {
    const std::lock_guard lock(mutex);
    given = std::exchange(parameters, std::nullopt);
  }
  if (given) invocation.parameters = *given;
  if (!run) {
    run = startInvocation(*registry, invocation, snapshot);
    title = registry->find(invocation.operatorId)->description().title;
  } else if (given) {
    run->set(*given);
  }
}

void OperatorJob::Shared::step() {
  prepareStep();
  StepProgress stepProgress(progress, fraction, std::min(lastShare, 1 - fraction));
  const StepState state = run->step(stepProgress);
  progress.throwIfCancelled();
  progress.report(state.fraction, title);
  lastShare = std::max(0.0, state.fraction - fraction);
  fraction = state.fraction;
  if (!state.finished) offerPreview(stepProgress);
  {
    const std::lock_guard lock(mutex);
    ++steps;
    if (state.curve) curve.push_back(*state.curve);
    inStep = false;
  }
  if (state.finished) finish();
}

void OperatorJob::Shared::offerPreview(const StepProgress& step) {
  if (!step.hasPublished() && !progress.hasPreview()) progress.publish(run->result().points);
}

void OperatorJob::Shared::finish() {
  FinishedRun done{.snapshot = snapshot};
  done.result = run ? run->result() : RunResult{.points = snapshot};
  if (run) done.report = run->report();
  done.edit = difference(snapshot, done.result.points, done.result.removedRows);
  // The next spell of a run that is set again counts from the beginning.
  fraction = 0;
  lastShare = 1;
  progress.takePreview();
  const std::lock_guard lock(mutex);
  result = std::move(done);
  ended = JobState::kFinished;
}

OperatorJob::OperatorJob(std::shared_ptr<const Registry> registry, Invocation invocation, PointSet snapshot,
                         JobOptions options)
    : shared_(new Shared{.registry = std::move(registry), .invocation = invocation, .snapshot = snapshot}),
      invocation_(std::move(invocation)),
      snapshot_(std::move(snapshot)) {
  shared_->isPaused = options.startPaused;
  options.threads.start(ThreadPriority::kLow, [shared = shared_] { shared->work(); });
}

OperatorJob::~OperatorJob() {
  if (shared_) cancel();
}

OperatorJob::OperatorJob(OperatorJob&&) noexcept = default;

OperatorJob& OperatorJob::operator=(OperatorJob&& other) noexcept {
  if (shared_) cancel();
  shared_ = std::move(other.shared_);
  invocation_ = std::move(other.invocation_);
  snapshot_ = std::move(other.snapshot_);
  return *this;
}

void OperatorJob::pause() {
  shared_->order([this] { shared_->isPaused = true; });
}

void OperatorJob::resume() {
  shared_->order([this] {
    shared_->isPaused = false;
    shared_->stepsAsked = 0;
  });
}

void OperatorJob::stepOnce() {
  shared_->order([this] {
    if (shared_->isPaused) ++shared_->stepsAsked;
  });
}

void OperatorJob::stop() {
  shared_->order([this] { shared_->isStopped = true; });
}

void OperatorJob::cancel() {
  shared_->order([this] { shared_->progress.cancel(); });
}

void OperatorJob::set(Parameters parameters) {
  shared_->order([&] {
    if (shared_->isStopped) return;
    invocation_.parameters = parameters;
    shared_->parameters = std::move(parameters);
  });
}

JobStatus OperatorJob::status() const {
  JobStatus status{.progress = shared_->progress.status()};
  const std::lock_guard lock(shared_->mutex);
  status.steps = shared_->steps;
  status.inStep = shared_->inStep;
  status.failure = shared_->failure;
  if (shared_->progress.cancelled()) {
    status.state = JobState::kCancelled;
  } else if (shared_->ended && !shared_->goesOn()) {
    status.state = *shared_->ended;
  } else if (shared_->isPaused && !shared_->goesOn()) {
    status.state = JobState::kPaused;
  }
  return status;
}

std::vector<double> OperatorJob::takeCurve() {
  const std::lock_guard lock(shared_->mutex);
  return std::exchange(shared_->curve, {});
}

std::optional<PointSet> OperatorJob::takePreview() {
  return shared_->progress.takePreview();
}

std::optional<FinishedRun> OperatorJob::takeResult() {
  const std::lock_guard lock(shared_->mutex);
  if (shared_->progress.cancelled() || shared_->goesOn()) return std::nullopt;
  return std::exchange(shared_->result, std::nullopt);
}

}  // namespace stipple
