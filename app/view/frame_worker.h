#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "app/view/frame_requests.h"
#include "app/view/surface_refiner.h"

namespace stipple {

/// A frame maker on a thread of its own: the owner asks and goes on, and takes pictures when they are ready.
class FrameWorker {
 public:
  /// `wake` is called on the worker's thread whenever there is a new picture; it must not wait.
  FrameWorker(std::unique_ptr<Renderer> renderer, std::function<void()> wake);
  ~FrameWorker();

  void post(SceneChange change, std::uint64_t revision);
  void setView(const View& view);
  void setAppearance(const Appearance& appearance);

  /// The newest picture; null before the first.
  std::shared_ptr<const Frame> latest() const;
  /// A sentence when drawing failed, once.
  std::optional<std::string> takeFailure();

 private:
  class Interrupt;

  void ask();
  void work();
  bool waitForWork();
  void workOnce();
  void fail(std::string sentence);

  FrameRequests requests_;
  SurfaceRefiner refiner_;
  FrameMaker maker_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool isAsked_ = false, isEnding_ = false;
  std::shared_ptr<const Frame> latest_;
  std::optional<std::string> failure_;
  std::thread thread_;  // last: it uses all the rest
};

}  // namespace stipple
