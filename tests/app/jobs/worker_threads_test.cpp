#include "app/jobs/worker_threads.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>

#include "core/parallel.h"
#include "tests/app/jobs/wait_until.h"

namespace stipple {
namespace {

using namespace std::chrono_literals;

TEST(WorkerThreads, CanBeWaitedFor) {
  const WorkerThreads threads, copy = threads;
  EXPECT_TRUE(threads.waitForAll(0ms));
  const auto goOn = std::make_shared<std::atomic<bool>>(false);
  for (int t = 0; t < 3; ++t) {
    threads.start(ThreadPriority::kNormal, [goOn] { waitUntil([&] { return goOn->load(); }); });
  }
  EXPECT_FALSE(copy.waitForAll(10ms));
  EXPECT_EQ(copy.running(), 3);
  *goOn = true;
  EXPECT_TRUE(copy.waitForAll(30s));
  EXPECT_EQ(threads.running(), 0);
}

TEST(WorkerThreads, OfLowPriorityYieldAndStillRunLoops) {
  const WorkerThreads threads;
  std::atomic<int> nice = -1, sum = 0;
  threads.start(ThreadPriority::kLow, [&] {
    nice = ::getpriority(PRIO_PROCESS, 0);
    parallelFor(100, 1, [&](std::size_t begin, std::size_t) { sum += static_cast<int>(begin); });
  });
  ASSERT_TRUE(threads.waitForAll(30s));
  EXPECT_EQ(sum, 4950);
#ifdef __linux__
  EXPECT_GE(nice, 10);
#endif
}

}  // namespace
}  // namespace stipple
