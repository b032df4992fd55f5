#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace stipple {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnceInBlocksOfTheGrain) {
  for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 1000u}) {
    std::vector<int> visits(count, 0);
    std::mutex mutex;
    std::set<std::pair<std::size_t, std::size_t>> blocks;
    parallelFor(count, 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
      const std::lock_guard lock(mutex);
      blocks.insert({begin, end});
    });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
    EXPECT_EQ(blocks.size(), (count + 63) / 64);
    for (const auto& [begin, end] : blocks) {
      EXPECT_EQ(begin % 64, 0u);
      EXPECT_EQ(end, std::min<std::size_t>(begin + 64, count));
    }
  }
}

TEST(ParallelFor, TakesAGrainOfZeroAsOne) {
  std::atomic<int> calls{0};
  parallelFor(5, 0, [&](std::size_t begin, std::size_t end) {
    EXPECT_EQ(end, begin + 1);
    ++calls;
  });
  EXPECT_EQ(calls, 5);
}

TEST(ParallelFor, ThrowsOnTheCallersThreadWhatABodyThrew) {
  const auto throwAt = [](std::size_t begin, std::size_t) {
    if (begin == 700) throw InvalidInput("block 700");
  };
  try {
    parallelFor(1000, 100, throwAt);
    FAIL() << "the exception was lost";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "block 700");
  }
  // Loops work as before afterwards.
  std::atomic<std::size_t> visited{0};
  parallelFor(1000, 100, [&](std::size_t begin, std::size_t end) { visited += end - begin; });
  EXPECT_EQ(visited, 1000u);
}

class StopsAfter final : public Progress {
 public:
  explicit StopsAfter(int blocks) : left_(blocks) {}
  void blockDone() { --left_; }
  bool cancelled() const override { return left_ <= 0; }

 private:
  std::atomic<int> left_;
};

TEST(ParallelFor, StopsBetweenBlocksWhenCancelled) {
  StopsAfter progress(3);
  std::atomic<int> blocks{0};
  const auto body = [&](std::size_t, std::size_t) {
    ++blocks;
    progress.blockDone();
  };
  EXPECT_THROW(parallelFor(100000, 1, body, &progress), Cancelled);
  EXPECT_LT(blocks, 1000) << "each thread may finish the block it is in";
}

TEST(ParallelFor, SaysSoWhenCancelledDuringTheLastBlock) {
  StopsAfter progress(1);
  EXPECT_THROW(parallelFor(
                   1, 1, [&](std::size_t, std::size_t) { progress.blockDone(); }, &progress),
               Cancelled);
}

TEST(ParallelFor, MayBeNested) {
  std::vector<int> visits(400, 0);
  parallelFor(20, 1, [&](std::size_t row, std::size_t) {
    parallelFor(20, 3, [&](std::size_t begin, std::size_t end) {
      for (std::size_t column = begin; column < end; ++column) ++visits[20 * row + column];
    });
  });
  EXPECT_EQ(visits, std::vector<int>(400, 1));
}

double harmonicSum(int threads) {
  const ThreadLimit limit(threads);
  return parallelSum(1000000, 1000, [](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += 1.0 / static_cast<double>(i + 1);
    return sum;
  });
}

TEST(ParallelSum, HasTheSameBitsForAnyNumberOfThreads) {
  const double sum = harmonicSum(1);
  // Euler's constant: H(n) = ln n + gamma + 1 / 2n - 1 / 12n^2.
  EXPECT_NEAR(sum, std::log(1e6) + 0.57721566490153286 + 0.5e-6 - 1e-12 / 12, 1e-11);
  for (const int threads : {2, 3, 8, 0}) {
    for (int again = 0; again < 5; ++again) EXPECT_EQ(harmonicSum(threads), sum) << threads << " threads";
  }
}

TEST(ParallelSum, OfNothingIsZero) {
  EXPECT_EQ(parallelSum(0, 10, [](std::size_t, std::size_t) { return 1.0; }), 0.0);
}

std::size_t threadsUsed() {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  parallelFor(200, 1, [&](std::size_t, std::size_t) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  return threads.size();
}

TEST(ThreadLimit, HoldsWhileItLives) {
  {
    const ThreadLimit one(1);
    EXPECT_EQ(threadsUsed(), 1u);
  }
  if (std::thread::hardware_concurrency() > 1) {
    EXPECT_GT(threadsUsed(), 1u);
  }
}

TEST(RunAtLowPriority, RunsLoopsOnTheThreadThatAskedAndPassesFailuresOn) {
  const std::thread::id asking = std::this_thread::get_id();
  std::atomic<std::size_t> sum = 0;
  runAtLowPriority([&] {
    EXPECT_EQ(std::this_thread::get_id(), asking);
    parallelFor(1000, 10, [&](std::size_t begin, std::size_t end) { sum += end - begin; });
  });
  EXPECT_EQ(sum, 1000u);
  const auto failing = [] { parallelFor(10, 1, [](std::size_t, std::size_t) { throw InvalidInput("no"); }); };
  EXPECT_THROW(runAtLowPriority(failing), InvalidInput);
}

}  // namespace
}  // namespace stipple
