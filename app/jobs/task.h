#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "app/jobs/task_progress.h"
#include "app/jobs/worker_threads.h"

namespace stipple {

struct TaskOptions {
  WorkerThreads threads = {};  ///< what waits for them waits for this task too
  ThreadPriority priority = ThreadPriority::kNormal;
};

/// Something that is computed on a thread of its own while the owner goes on. The owner asks; nobody calls
/// back. Ending a task cancels it and does not wait: the thread ends by itself and what it computed is
/// dropped.
template <class Result>
class Task {
 public:
  /// Starts `function`, which must own all that it needs.
  explicit Task(std::function<Result(Progress&)> function, const TaskOptions& options = {})
      : state_(std::make_shared<State>()) {
    options.threads.start(options.priority, [state = state_, function = std::move(function)]() mutable {
      std::optional<Result> result;
      std::exception_ptr failure;
      try {
        result = function(state->progress);
      } catch (...) {
        failure = std::current_exception();
      }
      function = nullptr;
      state->end(std::move(result), std::move(failure));
    });
  }
  ~Task() { cancel(); }
  Task(Task&&) noexcept = default;
  Task& operator=(Task&& other) noexcept {
    cancel();
    state_ = std::move(other.state_);
    return *this;
  }

  TaskStatus status() const { return state_->progress.status(); }
  bool isDone() const {
    const std::lock_guard lock(state_->mutex);
    return state_->isDone;
  }
  /// The latest state that the function has published since the last call.
  std::optional<PointSet> takePreview() { return state_->progress.takePreview(); }
  /// Once; throws what the function threw, Cancelled among it. Waits where the task is not done.
  Result takeResult() {
    std::unique_lock lock(state_->mutex);
    state_->done.wait(lock, [this] { return state_->isDone; });
    if (state_->failure) std::rethrow_exception(state_->failure);
    return std::move(*state_->result);
  }
  /// The function throws Cancelled the next time that it looks.
  void cancel() {
    if (state_) state_->progress.cancel();
  }

 private:
  struct State {
    TaskProgress progress;
    std::mutex mutex;
    std::condition_variable done;
    bool isDone = false;
    std::optional<Result> result;
    std::exception_ptr failure;

    void end(std::optional<Result> ended, std::exception_ptr thrown) {
      progress.rest();
      const std::lock_guard lock(mutex);
      result = std::move(ended);
      failure = std::move(thrown);
      isDone = true;
      done.notify_all();
    }
  };

  std::shared_ptr<State> state_;
};

}  // namespace stipple
