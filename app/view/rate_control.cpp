#include "app/view/rate_control.h"

#include <algorithm>
#include <cmath>

namespace stipple {

namespace {

constexpr double kFade = 0.8;
// What is believed before anything was measured, as if of frames that spread by so many splats.
constexpr double kSplatCost = 1e-4, kPriorSpread = 1e5;  // milliseconds; splats
// tau that differs by less is not worth a change of picture.
constexpr float kDeadBand = 0.12f;

}  // namespace

void RateControl::drew(Index splats, float tau, double milliseconds) {
  const auto n = static_cast<double>(splats);
  weight_ = kFade * weight_ + 1;
  splats_ = kFade * splats_ + n;
  time_ = kFade * time_ + milliseconds;
  squares_ = kFade * squares_ + n * n;
  products_ = kFade * products_ + n * milliseconds;
  lastTau_ = tau;
  lastSplats_ = n;
}

// Drawn to the cost of a splat that is believed at first.
RateControl::Cost RateControl::cost() const {
  const double meanSplats = splats_ / weight_, meanTime = time_ / weight_;
  const double spread = std::max(0.0, squares_ / weight_ - meanSplats * meanSplats);
  const double common = products_ / weight_ - meanSplats * meanTime;
  const double prior = kPriorSpread * kPriorSpread * 0.05;
  const double ofSplat = std::max(1e-6, (common + prior * kSplatCost) / (spread + prior));
  return {.ofSplat = ofSplat, .ofPicture = std::max(0.0, meanTime - ofSplat * meanSplats)};
}

double RateControl::pictureCost() const {
  return weight_ > 0 ? cost().ofPicture : 0;
}

float RateControl::tauFor(double milliseconds) {
  if (weight_ == 0 || lastSplats_ < 1) return told_;
  const auto [ofSplat, ofPicture] = cost();
  const double forSplats = std::max(milliseconds - ofPicture, 0.5 * ofPicture);
  const double affordable = std::max(forSplats / ofSplat, 0.02 * lastSplats_);
  // Nodes of a cut go with 1 / tau^2.
  const float wanted = lastTau_ * static_cast<float>(std::sqrt(lastSplats_ / affordable));
  const float tau = std::clamp(wanted, std::max(kFinest, told_ / 1.5f), std::min(kCoarsest, told_ * 2));
  if (std::abs(tau - told_) > kDeadBand * told_ || tau == kFinest) told_ = tau;
  return told_;
}

}  // namespace stipple
