#include "app/tools/dab_path.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stipple {

namespace {

// One event brings no more stations than this: a pointer that comes from far outside.
constexpr double kMostStations = 2000;
// From pixel to pixel the surface goes back by its slope: by 8 at 83 degrees. More is a gap.
constexpr float kSteepest = 8;

}  // namespace

DabPath::DabPath(const DabPathOptions& options, const glm::vec2& px, const Picked& picked, float pressure)
    : options_(options),
      px_(px),
      pressure_(pressure),
      last_{px, picked, pressure},
      lastDab_(picked.position) {}

// Less than a pixel would only repeat places.
float DabPath::spacingAt(float pressure, float depth, const View& view) const {
  const float size = options_.pressureScalesRadius ? std::max(pressure, kLeastPenSize) : 1;
  return std::max(options_.spacing * options_.radius * size, 1 / view.pixelsPerUnit(depth));
}

bool DabPath::isGap(const Station& next, const View& view) const {
  const float step = glm::distance(next.picked.position, last_.picked.position);
  const float nearer = std::min(next.picked.depth, last_.picked.depth);
  const float across = glm::distance(next.px, last_.px) / view.pixelsPerUnit(nearer);
  return step > std::max(options_.radius, kSteepest * across);
}

std::vector<PathDab> DabPath::extendTo(const glm::vec2& px, float pressure, const View& view,
                                       const PickAt& pickAt) {
  std::vector<PathDab> dabs;
  const float spacingPx = spacingAt(std::min(pressure, pressure_), last_.picked.depth, view) *
                          view.pixelsPerUnit(last_.picked.depth);
  // From dab to dab at least two stations, so that the way between them is seen, and at most four: the steps
  // of a way from pixel to pixel would add up to more than its length.
  const float length = glm::distance(px, px_);
  if (!std::isfinite(length)) return dabs;
  const auto stations =
      static_cast<int>(std::min<double>(length / std::max(0.25f * spacingPx, 1.f), kMostStations));
  if (stations == 0) return dabs;
  const glm::vec2 from = px_;
  const float pressureFrom = pressure_;
  for (int s = 1; s <= stations; ++s) {
    const float t = static_cast<float>(s) / static_cast<float>(stations);
    Station next{glm::mix(from, px, t), {}, glm::mix(pressureFrom, pressure, t)};
    const std::optional<Picked> picked = pickAt(next.px);
    if (!picked) {
      onSurface_ = false;
      continue;
    }
    next.picked = *picked;
    const float spacing = spacingAt(next.pressure, picked->depth, view);
    if (onSurface_ && !isGap(next, view)) {
      goOn(next, spacing, pickAt, dabs);
    } else {
      beginPiece(next, spacing, dabs);
    }
    onSurface_ = true;
    last_ = next;
  }
  px_ = px;
  pressure_ = pressure;
  return dabs;
}

void DabPath::goOn(const Station& next, float spacing, const PickAt& pickAt, std::vector<PathDab>& dabs) {
  const float step = glm::distance(next.picked.position, last_.picked.position);
  const int count = std::max(static_cast<int>((travelled_ + step) / spacing), 0);
  for (int d = 1; d <= count; ++d) {
    const float covered = static_cast<float>(d) * spacing - travelled_;
    const float t = step > 0 ? std::clamp(covered / step, 0.f, 1.f) : 1;
    const glm::vec3 expected = glm::mix(last_.picked.position, next.picked.position, t);
    const std::optional<Picked> picked = pickAt(glm::mix(last_.px, next.px, t));
    // A hole smaller than a step of the pointer: the station at its rim.
    const bool isNear = picked && glm::distance(picked->position, expected) <= std::max(step, spacing);
    lastDab_ = isNear ? picked->position : (t < 0.5f ? last_ : next).picked.position;
    dabs.push_back({lastDab_, glm::mix(last_.pressure, next.pressure, t)});
  }
  travelled_ += step - static_cast<float>(count) * spacing;
}

// At a rim the pointer may leave and reach the surface at every pixel: dabs keep their spacing there too.
void DabPath::beginPiece(const Station& next, float spacing, std::vector<PathDab>& dabs) {
  travelled_ = glm::distance(next.picked.position, lastDab_);
  if (travelled_ < spacing) return;
  lastDab_ = next.picked.position;
  travelled_ = 0;
  dabs.push_back({lastDab_, next.pressure});
}

}  // namespace stipple
