#include "app/view/surface_refiner.h"

#include <new>
#include <utility>

namespace stipple {

namespace {

class UntilStopped final : public Progress {
 public:
  explicit UntilStopped(const std::atomic<bool>& stopped) : stopped_(stopped) {}
  bool cancelled() const override { return stopped_; }

 private:
  const std::atomic<bool>& stopped_;
};

}  // namespace

void SurfaceRefiner::start(Unrefined unrefined, std::function<void()> wake) {
  *stopped_ = true;
  stopped_ = std::make_shared<std::atomic<bool>>(false);
  threads_.start(ThreadPriority::kLow,
                 [this, stopped = stopped_, held = std::move(unrefined), wake = std::move(wake)] {
                   const UntilStopped progress(*stopped);
                   try {
                     const std::vector<Rgba8> colors = held.colors.of(held.points);
                     Hierarchy refined = refineHierarchy(held.points, colors, &progress);
                     progress.throwIfCancelled();
                     requests_.post(Refined{.surface = held.surface, .hierarchy = std::move(refined)}, 0);
                     wake();
                   } catch (const Error&) {
                     // Stopped, or points that nothing can be said about: the picture stays as it is.
                   } catch (const std::bad_alloc&) {
                   }
                 });
}

void SurfaceRefiner::stop() {
  *stopped_ = true;
  while (!threads_.waitForAll(std::chrono::seconds(1))) {
  }
}

}  // namespace stipple
