#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "app/jobs/worker_threads.h"
#include "app/view/frame_requests.h"

namespace stipple {

/// Makes the better hierarchy of a surface aside, at low priority, and posts it.
class SurfaceRefiner {
 public:
  explicit SurfaceRefiner(FrameRequests& requests) : requests_(requests) {}
  ~SurfaceRefiner() { stop(); }
  SurfaceRefiner(const SurfaceRefiner&) = delete;
  SurfaceRefiner& operator=(const SurfaceRefiner&) = delete;

  /// Drops what it was at. `wake` is called after the result was posted.
  void start(Unrefined unrefined, std::function<void()> wake);
  /// Waits until nothing of it is at work.
  void stop();

 private:
  FrameRequests& requests_;
  WorkerThreads threads_;
  std::shared_ptr<std::atomic<bool>> stopped_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace stipple
