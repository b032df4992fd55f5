#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/invocation.h"
#include "app/document/merge.h"
#include "app/jobs/task_progress.h"
#include "app/jobs/worker_threads.h"

namespace stipple {

enum class JobState { kRunning, kPaused, kFinished, kFailed, kCancelled };

struct JobStatus {
  JobState state = JobState::kRunning;
  TaskStatus progress = {};
  int steps = 0;             ///< complete ones
  bool inStep = false;       ///< also while paused, until the step that was going on ends
  std::string failure = {};  ///< one sentence, where it failed
};

struct JobOptions {
  bool startPaused = false;
  WorkerThreads threads = {};
};

/// One operator at work on a snapshot, on a thread of low priority. The owner asks; nobody calls back.
/// Nothing waits for the operator: ending or cancelling a job abandons a step that does not end, and what it
/// computes is dropped.
class OperatorJob {
 public:
  /// The registry lives as long as the last thread.
  OperatorJob(std::shared_ptr<const Registry> registry, Invocation invocation, PointSet snapshot,
              JobOptions options = {});
  ~OperatorJob();
  OperatorJob(OperatorJob&&) noexcept;
  OperatorJob& operator=(OperatorJob&&) noexcept;

  /// With the parameters set last, as it stands in a recipe.
  const Invocation& invocation() const { return invocation_; }
  const PointSet& snapshot() const { return snapshot_; }

  /// After the step that is going on.
  void pause();
  void resume();
  /// One step of a paused job.
  void stepOnce();
  /// Finishes after the step that is going on, with the state that it leaves; for good.
  void stop();
  /// For good, and at once.
  void cancel();
  /// Acts at the next step. A finished run goes on with it: one of a single step is done again.
  void set(Parameters parameters);

  /// `progress.fraction` is that of the run; within its first step, which may be its only one, that of the
  /// step.
  JobStatus status() const;
  /// The values to plot of the steps since the last call.
  std::vector<double> takeCurve();
  /// The latest intermediate state since the last call: what the operator published, or what it had after a
  /// step. States are only made after the last one was taken.
  std::optional<PointSet> takePreview();
  /// Of a finished job, once for each time that it finishes.
  std::optional<FinishedRun> takeResult();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  Invocation invocation_;
  PointSet snapshot_;
};

}  // namespace stipple
