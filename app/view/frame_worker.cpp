#include "app/view/frame_worker.h"

#include <fmt/format.h>

#include <new>
#include <utility>

namespace stipple {

// What refines a picture ends when anything is asked for; what builds a surface, when there is a newer one.
class FrameWorker::Interrupt final : public Progress {
 public:
  Interrupt(const FrameWorker& worker, bool byAnything) : worker_(worker), byAnything_(byAnything) {}
  bool cancelled() const override {
    if (byAnything_ ? worker_.requests_.hasAny() : worker_.requests_.hasNewSurface()) return true;
    const std::lock_guard lock(worker_.mutex_);
    return worker_.isEnding_;
  }

 private:
  const FrameWorker& worker_;
  bool byAnything_;
};

FrameWorker::FrameWorker(std::unique_ptr<Renderer> renderer, std::function<void()> wake)
    : refiner_(requests_), maker_(std::move(renderer)), wake_(std::move(wake)) {
  maker_.mayCoarsenPixels = true;
  thread_ = std::thread([this] { work(); });
}

FrameWorker::~FrameWorker() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void FrameWorker::ask() {
  {
    const std::lock_guard lock(mutex_);
    isAsked_ = true;
  }
  changed_.notify_one();
}

void FrameWorker::post(SceneChange change, std::uint64_t revision) {
  requests_.post(std::move(change), revision);
  ask();
}

void FrameWorker::setView(const View& view) {
  requests_.setView(view);
  ask();
}

void FrameWorker::setAppearance(const Appearance& appearance) {
  requests_.setAppearance(appearance);
  ask();
}

std::shared_ptr<const Frame> FrameWorker::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

std::optional<std::string> FrameWorker::takeFailure() {
  const std::lock_guard lock(mutex_);
  return std::exchange(failure_, {});
}

void FrameWorker::fail(std::string sentence) {
  {
    const std::lock_guard lock(mutex_);
    failure_ = std::move(sentence);
  }
  wake_();
}

// False at the end.
bool FrameWorker::waitForWork() {
  const auto due = maker_.nextDue();
  std::unique_lock lock(mutex_);
  const auto isNeeded = [&] { return isAsked_ || isEnding_; };
  if (due)
    changed_.wait_until(lock, *due, isNeeded);
  else
    changed_.wait(lock, isNeeded);
  isAsked_ = false;
  return !isEnding_;
}

void FrameWorker::work() {
  while (waitForWork()) {
    try {
      workOnce();
    } catch (const Cancelled&) {
    } catch (const std::bad_alloc&) {
      fail("There is not enough memory to show this.");
    } catch (const std::exception& error) {
      fail(fmt::format("This cannot be shown: {}.", error.what()));
    }
  }
  refiner_.stop();
}

void FrameWorker::workOnce() {
  const Interrupt newer(*this, false), anything(*this, true);
  requests_.applyTo(maker_, &newer);
  if (maker_.step(&anything)) {
    auto frame = std::make_shared<const Frame>(maker_.frame());
    {
      const std::lock_guard lock(mutex_);
      latest_ = std::move(frame);
    }
    wake_();
  }
  if (auto waiting = maker_.takeUnrefined()) {
    refiner_.start(std::move(*waiting), [this] { ask(); });
  }
}

}  // namespace stipple
