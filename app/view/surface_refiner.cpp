#include "app/view/surface_refiner.h"

#include <new>

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

void SurfaceRefiner::start(std::uint64_t surface, PointSet points, std::function<void()> wake) {
  stop();
  cancelled_ = false;
  thread_ = std::thread([this, surface, held = std::move(points), wake = std::move(wake)]() mutable {
    const UntilStopped progress(cancelled_);
    try {
      Hierarchy refined = refineHierarchy(held, memoryBudget, &progress);
      held = {};
      requests_.post(Refined{.surface = surface, .hierarchy = std::move(refined)}, 0);
      wake();
    } catch (const Error&) {
      // Stopped, or points that nothing can be said about: the picture stays as it is.
    } catch (const std::bad_alloc&) {
    }
  });
}

void SurfaceRefiner::stop() {
  cancelled_ = true;
  if (thread_.joinable()) thread_.join();
}

}  // namespace stipple
