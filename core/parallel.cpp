#include "core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#ifndef STIPPLE_STD_THREADS
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace stipple {

#ifdef STIPPLE_STD_THREADS

namespace {

std::atomic<int> threadLimit{0};

int threadCount() {
  const int limit = threadLimit.load();
  return limit > 0 ? limit : std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
}

// Blocks are handed out by a counter; the first exception wins.
void forEachBlock(std::size_t blocks, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failureMutex;
  auto work = [&] {
    for (std::size_t block = next++; block < blocks; block = next++) {
      try {
        body(block);
      } catch (...) {
        const std::lock_guard lock(failureMutex);
        if (!failure) failure = std::current_exception();
        next = blocks;
      }
    }
  };
  std::vector<std::jthread> threads;
  const auto helpers = std::min<std::size_t>(threadCount(), blocks);
  for (std::size_t t = 1; t < helpers; ++t) threads.emplace_back(work);
  work();
  threads.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

// Threads that a loop starts have the priority of the one that starts them.
void runAtLowPriority(const std::function<void()>& body) {
  body();
}

ThreadLimit::ThreadLimit(int threads) {
  control_ = new int(threadLimit.exchange(threads));
}

ThreadLimit::~ThreadLimit() {
  auto* previous = static_cast<int*>(control_);
  threadLimit = *previous;
  delete previous;
}

#else

namespace {

void forEachBlock(std::size_t blocks, const std::function<void(std::size_t)>& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, 1), [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t block = range.begin(); block < range.end(); ++block) body(block);
  });
}

}  // namespace

void runAtLowPriority(const std::function<void()>& body) {
  tbb::task_arena arena(tbb::task_arena::automatic, 1, tbb::task_arena::priority::low);
  arena.execute(body);
}

ThreadLimit::ThreadLimit(int threads) {
  if (threads > 0) {
    control_ = new tbb::global_control(tbb::global_control::max_allowed_parallelism, threads);
  }
}

ThreadLimit::~ThreadLimit() {
  delete static_cast<tbb::global_control*>(control_);
}

#endif

void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t, std::size_t)>& body, const Progress* progress) {
  const std::size_t step = std::max<std::size_t>(grain, 1);
  forEachBlock((count + step - 1) / step, [&](std::size_t block) {
    if (progress) progress->throwIfCancelled();
    body(block * step, std::min(count, (block + 1) * step));
  });
  if (progress) progress->throwIfCancelled();
}

double parallelSum(std::size_t count, std::size_t grain,
                   const std::function<double(std::size_t, std::size_t)>& body) {
  const std::size_t step = std::max<std::size_t>(grain, 1);
  std::vector<double> parts((count + step - 1) / step, 0.0);
  parallelFor(count, step, [&](std::size_t begin, std::size_t end) { parts[begin / step] = body(begin, end); });
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

}  // namespace stipple
