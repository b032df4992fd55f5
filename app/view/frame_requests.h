#pragma once

#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "app/view/frame_maker.h"

namespace stipple {

/// What the owner of a view asks its frame maker for. Any thread may ask, and never waits for a picture; what
/// a later request makes pointless is dropped.
class FrameRequests {
 public:
  void post(SceneChange change, std::uint64_t revision);
  void setView(const View& view);
  void setAppearance(const Appearance& appearance);

  bool hasAny() const;
  /// A surface waits that replaces the one at work.
  bool hasNewSurface() const;
  /// Hands all of it to the maker.
  void applyTo(FrameMaker& maker, const Progress* progress);

 private:
  mutable std::mutex mutex_;
  std::vector<std::pair<SceneChange, std::uint64_t>> changes_;
  std::optional<View> view_;
  std::optional<Appearance> appearance_;
};

}  // namespace stipple
