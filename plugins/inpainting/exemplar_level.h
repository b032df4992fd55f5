#pragma once

#include <cmath>
#include <limits>

#include "plugins/inpainting/patches.h"
#include "plugins/inpainting/surround.h"

namespace stipple {

/// How much less counts what lies so many steps from what is known (Wexler et al. 2007).
inline float fading(int hops) {
  return std::pow(1.3f, -static_cast<float>(hops));
}

constexpr Index kNoRow = std::numeric_limits<Index>::max();

/// The surroundings of a part of the mask at one spacing: patches to compare, and patches to take from.
struct ExemplarLevel {
  std::vector<Index> finer;  ///< which site of the next finer level each site is; empty at the finest
  TangentPlaces surface;
  std::vector<Surround::Kind> kinds;
  std::vector<int> hops;  ///< 0 where known, else steps from there
  Features features;      ///< what patches are compared by; those of targets change

  std::vector<Index> targets;
  std::vector<Index> compared;          ///< sites whose patches hold a target, all targets among them
  std::vector<Index> comparedRows;      ///< site -> row of compared, or kNoRow
  std::vector<PatchStencil> stencils;   ///< parallel to compared
  std::vector<SampleArray> confidence;  ///< parallel to compared: what samples count, their sum is 1 (or 0)

  std::vector<Index> sources;          ///< sites whose patches are whole and known
  std::vector<std::uint8_t> isSource;  ///< of each site
  Features patches;                    ///< sites x (channels x 37); of sources only
};

/// The finest level. `frames` from carryFrames.
ExemplarLevel makeFinestLevel(const Surround& surround, std::vector<Eigen::Matrix3f> frames,
                              Features features, float spacing, const Progress* progress = nullptr);

/// Every so many sites of a level, at twice its spacing, with means of the features around them.
ExemplarLevel thinLevel(const ExemplarLevel& fine, const Progress* progress = nullptr);

}  // namespace stipple
