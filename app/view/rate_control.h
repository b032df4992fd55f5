#pragma once

#include "core/parallel.h"

namespace stipple {

/// Learns from the frames that were drawn what a splat and what a picture cost, and says how coarse the next
/// one must be to be done in time. Frames are few and noisy: old ones fade, and what it says changes only
/// where that makes a difference.
class RateControl {
 public:
  /// tau in pixels: the finest that is ever asked for, and the coarsest that still shows something.
  static constexpr float kFinest = 3, kCoarsest = 24;

  /// A frame of `splats` nodes at `tau`, in milliseconds from the beginning of the cut to the picture.
  void drew(Index splats, float tau, double milliseconds);
  /// For a frame of about `milliseconds` of the same view. Where the picture alone takes longer, splats get
  /// half as much time as it does.
  float tauFor(double milliseconds);
  /// What a picture costs by itself, milliseconds; 0 while nothing is known.
  double pictureCost() const;

 private:
  /// A line through the frames.
  struct Cost {
    double ofSplat, ofPicture;
  };
  Cost cost() const;

  double weight_ = 0, splats_ = 0, time_ = 0, squares_ = 0, products_ = 0;  // fading sums
  float lastTau_ = 6;
  double lastSplats_ = 0;
  float told_ = 6;
};

}  // namespace stipple
