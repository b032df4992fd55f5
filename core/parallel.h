#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/progress.h"

namespace stipple {

/// Row of a point set, of a matrix, of a list.
using Index = std::uint32_t;

/// Calls body(begin, end) for the blocks [0, grain), [grain, 2 grain), ... of [0, count) on all threads.
/// Block borders depend only on `grain`, so results that a body derives from its block do not depend on the
/// number of threads. Stops between blocks and throws Cancelled when `progress` says so; an exception of a
/// body ends the loop and is thrown again here.
void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body,
                 const Progress* progress = nullptr);

/// Sum of body(begin, end) over blocks of `grain`, added in the order of the blocks: same bits for any number
/// of threads.
double parallelSum(std::size_t count, std::size_t grain,
                   const std::function<double(std::size_t begin, std::size_t end)>& body);

/// Calls `body`, whose parallel loops leave threads to those that others run meanwhile. The calling thread
/// keeps the priority that it has.
void runAtLowPriority(const std::function<void()>& body);

/// While it lives, parallel loops use at most `threads` threads (0 = all cores).
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_ = nullptr;
};

}  // namespace stipple
