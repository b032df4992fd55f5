#pragma once

#include <chrono>
#include <functional>
#include <memory>

namespace stipple {

/// Low: the thread and the parallel loops that it starts yield to those of the window.
enum class ThreadPriority { kNormal, kLow };

/// Threads that nobody joins: their owners may lose interest and go on. Copies count together, so that
/// whoever ends the program can wait a while for those that were abandoned.
class WorkerThreads {
 public:
  WorkerThreads();

  /// `body` must not throw and must own all that it needs.
  void start(ThreadPriority priority, std::function<void()> body) const;
  int running() const;
  /// Whether all have ended, after `longest` at most.
  bool waitForAll(std::chrono::milliseconds longest) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace stipple
