#pragma once

#include <atomic>
#include <cstddef>
#include <thread>

#include "app/view/frame_requests.h"

namespace stipple {

/// Makes the better hierarchy of a surface aside, at low priority, and posts it.
class SurfaceRefiner {
 public:
  explicit SurfaceRefiner(FrameRequests& requests) : requests_(requests) {}
  ~SurfaceRefiner() { stop(); }

  /// Drops what it was at. `wake` is called after the result was posted.
  void start(std::uint64_t surface, PointSet points, std::function<void()> wake);
  void stop();

  /// Bytes that local fans may take; surfaces that need more keep discs from blocks.
  std::size_t memoryBudget = std::size_t{3} << 30;

 private:
  FrameRequests& requests_;
  std::atomic<bool> cancelled_ = false;
  std::thread thread_;
};

}  // namespace stipple
