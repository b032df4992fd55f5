#include "app/jobs/task.h"

#include <gmock/gmock.h>

#include <atomic>

#include "tests/app/jobs/wait_until.h"

namespace stipple {
namespace {

using namespace std::chrono_literals;
using testing::ThrowsMessage;

TEST(Task, ComputesWhileTheOwnerGoesOn) {
  Task<std::string> task([](Progress& progress) {
    progress.report(0.5, "halfway");
    progress.publish(PointSet(std::vector<Eigen::Vector3f>(3)));
    return std::string("done");
  });
  EXPECT_TRUE(waitUntil([&] { return task.isDone(); }));
  EXPECT_EQ(task.status().message, "halfway");
  EXPECT_EQ(task.status().fraction, 0.5);
  EXPECT_EQ(task.takePreview()->size(), 3u);
  EXPECT_EQ(task.takeResult(), "done");
}

TEST(Task, ThrowsWhatItsFunctionThrew) {
  Task<int> task([](Progress&) -> int { throw InvalidInput("the file is empty"); });
  EXPECT_THAT([&] { task.takeResult(); }, ThrowsMessage<InvalidInput>("the file is empty"));
}

TEST(Task, StopsWhenCancelled) {
  const auto untilCancelled = [](Progress& progress) -> int {
    waitUntil([&] { return progress.cancelled(); });
    progress.throwIfCancelled();
    return 1;
  };
  Task<int> task(untilCancelled);
  EXPECT_FALSE(task.isDone());
  task.cancel();
  EXPECT_THROW(task.takeResult(), Cancelled);
}

TEST(Task, EndingItAbandonsItsThread) {
  const WorkerThreads threads;
  const auto goOn = std::make_shared<std::atomic<bool>>(false);
  const auto kept = std::make_shared<int>(7);
  const auto deaf = [goOn, kept](Progress&) {
    waitUntil([&] { return goOn->load(); });
    return *kept;
  };
  {
    Task<int> task(deaf, {.threads = threads});
    const Task<int> moved = std::move(task);
  }
  EXPECT_EQ(threads.running(), 1) << "nobody waited for it";
  *goOn = true;
  EXPECT_TRUE(threads.waitForAll(30s));
}

TEST(Task, AssigningAnotherCancelsTheFirst) {
  const WorkerThreads threads;
  const auto sawCancel = std::make_shared<std::atomic<bool>>(false);
  Task<int> task(
      [sawCancel](Progress& progress) {
        *sawCancel = waitUntil([&] { return progress.cancelled(); });
        return 1;
      },
      {.threads = threads});
  task = Task<int>([](Progress&) { return 2; }, {.threads = threads, .priority = ThreadPriority::kLow});
  EXPECT_EQ(task.takeResult(), 2);
  EXPECT_TRUE(threads.waitForAll(30s));
  EXPECT_TRUE(*sawCancel);
}

}  // namespace
}  // namespace stipple
