#include "app/document/saved_state.h"

#include <algorithm>

namespace stipple {

namespace {

constexpr std::size_t kLongestTrail = 4096;  // far more steps than are done while a file is written

}  // namespace

void SavedState::note(std::uint64_t revision, std::optional<std::size_t> state) {
  if (trail_.back().second == state) return;
  trail_.emplace_back(revision, state);
  if (trail_.size() > kLongestTrail) trail_.pop_front();
}

void SavedState::branch(std::size_t state) {
  if (saved_ > state) saved_.reset();
  for (auto& [revision, shown] : trail_) {
    if (shown > state) shown.reset();
  }
}

std::optional<std::size_t> SavedState::stateAt(std::uint64_t revision) const {
  const auto after =
      std::ranges::upper_bound(trail_, revision, {}, [](const auto& step) { return step.first; });
  return after == trail_.begin() ? std::nullopt : std::prev(after)->second;
}

}  // namespace stipple
