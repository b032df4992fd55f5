#include "app/jobs/task_progress.h"

#include <gtest/gtest.h>

#include <thread>

namespace stipple {
namespace {

using namespace std::chrono_literals;

TEST(TaskProgress, TellsTheTimeLeftOnceItCanBeKnown) {
  TaskProgress progress;
  progress.report(0.5, "halfway");
  EXPECT_FALSE(progress.status().secondsLeft) << "it has just begun";
  std::this_thread::sleep_for(600ms);
  const TaskStatus status = progress.status();
  EXPECT_EQ(status.message, "halfway");
  EXPECT_GE(status.seconds, 0.6);
  EXPECT_NEAR(status.secondsLeft.value(), status.seconds, 1e-9);
  progress.report(0.75, "later");
  EXPECT_LT(progress.status().secondsLeft.value(), 0.5 * progress.status().seconds);
}

TEST(TaskProgress, TheClockStandsWhileItRests) {
  TaskProgress progress;
  progress.rest();
  const double seconds = progress.status().seconds;
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(progress.status().seconds, seconds);
  progress.work();
  std::this_thread::sleep_for(20ms);
  EXPECT_GE(progress.status().seconds, seconds + 0.02);
}

TEST(TaskProgress, HandsOutTheLatestStateOnce) {
  TaskProgress progress;
  EXPECT_FALSE(progress.takePreview());
  progress.publish(PointSet(std::vector<Eigen::Vector3f>(1)));
  progress.publish(PointSet(std::vector<Eigen::Vector3f>(2)));
  EXPECT_TRUE(progress.hasPreview());
  EXPECT_EQ(progress.takePreview()->size(), 2u);
  EXPECT_FALSE(progress.takePreview());
}

}  // namespace
}  // namespace stipple
