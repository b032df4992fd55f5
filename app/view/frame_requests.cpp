#include "app/view/frame_requests.h"

#include <algorithm>

namespace stipple {

namespace {

template <class T>
bool is(const std::pair<SceneChange, std::uint64_t>& held) {
  return std::holds_alternative<T>(held.first);
}

}  // namespace

void FrameRequests::post(SceneChange change, std::uint64_t revision) {
  const std::lock_guard lock(mutex_);
  if (std::holds_alternative<NewSurface>(change)) changes_.clear();
  if (auto* fresh = std::get_if<Restate>(&change)) {
    // Whether points moved meanwhile must not be lost with what it replaces.
    for (const auto& [held, ignored] : changes_) {
      if (const auto* earlier = std::get_if<Restate>(&held)) fresh->moved = fresh->moved || earlier->moved;
    }
    std::erase_if(changes_, [](const auto& held) { return is<Restate>(held) || is<Recolor>(held); });
  }
  changes_.emplace_back(std::move(change), revision);
}

void FrameRequests::setView(const View& view) {
  const std::lock_guard lock(mutex_);
  view_ = view;
}

void FrameRequests::setAppearance(const Appearance& appearance) {
  const std::lock_guard lock(mutex_);
  appearance_ = appearance;
}

bool FrameRequests::hasAny() const {
  const std::lock_guard lock(mutex_);
  return !changes_.empty() || view_ || appearance_;
}

bool FrameRequests::hasNewSurface() const {
  const std::lock_guard lock(mutex_);
  return std::ranges::any_of(changes_, is<NewSurface>);
}

void FrameRequests::applyTo(FrameMaker& maker, const Progress* progress) {
  FrameRequests taken;
  {
    const std::lock_guard lock(mutex_);
    taken.changes_.swap(changes_);
    std::swap(taken.view_, view_);
    std::swap(taken.appearance_, appearance_);
  }
  if (taken.appearance_) maker.setAppearance(*taken.appearance_);
  if (taken.view_) maker.setView(*taken.view_);
  for (auto& [change, revision] : taken.changes_) maker.apply(std::move(change), revision, progress);
}

}  // namespace stipple
