#include "app/view/frame_worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>

#include "tests/app/view/shown_points.h"

namespace stipple {
namespace {

using namespace std::chrono_literals;

// Waits until the worker has made a picture that `isWanted`.
std::shared_ptr<const Frame> waitFor(const FrameWorker& worker,
                                     const std::function<bool(const Frame&)>& isWanted) {
  for (int tries = 0; tries < 4000; ++tries) {
    auto frame = worker.latest();
    if (frame && isWanted(*frame)) return frame;
    std::this_thread::sleep_for(5ms);
  }
  return nullptr;
}

View view(float yaw) {
  return frameView({{0, 0, 0}, 1}, {.yaw = yaw}, 160, 120);
}

TEST(FrameWorker, ShowsRefinesAndFollows) {
  const PointSet points = shownSphere(20000);
  std::atomic<int> woken = 0;
  FrameWorker worker(makeRenderer(Backend::kCpu), [&] { ++woken; });
  worker.setView(view(0));
  worker.post(NewSurface{.surface = 1, .points = points, .colors = PointColors(points, {})}, 1);
  ASSERT_TRUE(waitFor(worker, [](const Frame& frame) { return frame.averaged == 16; }));
  EXPECT_GE(woken, 2);
  worker.post(Recolor{.rows = {1}, .colors = {{9, 9, 9, 0}}}, 2);
  ASSERT_TRUE(waitFor(worker, [](const Frame& frame) { return frame.revision == 2; }));
  worker.setView(view(1));
  ASSERT_TRUE(waitFor(worker, [](const Frame& frame) { return frame.view.eye == view(1).eye; }));
}

TEST(FrameWorker, EndsInTheMiddleOfEverything) {
  const PointSet points = shownSphere(200000);
  for (const auto wait : {0ms, 5ms, 40ms, 300ms, 700ms}) {
    FrameWorker worker(makeRenderer(Backend::kCpu), [] {});
    worker.setView(view(0));
    worker.post(NewSurface{.surface = 1, .points = points, .colors = PointColors(points, {})}, 1);
    std::this_thread::sleep_for(wait);
  }
}

TEST(FrameWorker, TheLastOfManyViewsIsShown) {
  const PointSet points = shownSphere(50000);
  FrameWorker worker(makeRenderer(Backend::kCpu), [] {});
  worker.post(NewSurface{.surface = 1, .points = points, .colors = PointColors(points, {})}, 1);
  for (int i = 0; i < 200; ++i) worker.setView(view(0.01f * static_cast<float>(i)));
  EXPECT_TRUE(waitFor(
      worker, [](const Frame& frame) { return frame.view.eye == view(1.99f).eye && frame.isConverged; }));
}

}  // namespace
}  // namespace stipple
