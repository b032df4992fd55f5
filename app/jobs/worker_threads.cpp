#include "app/jobs/worker_threads.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "core/parallel.h"

namespace stipple {

namespace {

// On Linux a thread has a priority of its own. 10 leaves nine tenths of a core to a thread at 0 that wants
// it.
void lowerPriority() {
#ifdef __linux__
  constexpr int kNice = 10;
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
#endif
}

}  // namespace

struct WorkerThreads::State {
  std::mutex mutex;
  std::condition_variable ended;
  int running = 0;
};

WorkerThreads::WorkerThreads() : state_(std::make_shared<State>()) {}

void WorkerThreads::start(ThreadPriority priority, std::function<void()> body) const {
  {
    const std::lock_guard lock(state_->mutex);
    ++state_->running;
  }
  std::thread([state = state_, priority, body = std::move(body)]() mutable {
    if (priority == ThreadPriority::kLow) {
      lowerPriority();
      runAtLowPriority(body);
    } else {
      body();
    }
    body = nullptr;
    const std::lock_guard lock(state->mutex);
    --state->running;
    state->ended.notify_all();
  }).detach();
}

int WorkerThreads::running() const {
  const std::lock_guard lock(state_->mutex);
  return state_->running;
}

bool WorkerThreads::waitForAll(std::chrono::milliseconds longest) const {
  std::unique_lock lock(state_->mutex);
  return state_->ended.wait_for(lock, longest, [this] { return state_->running == 0; });
}

}  // namespace stipple
