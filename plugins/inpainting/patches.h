#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "plugins/inpainting/tangent_places.h"

namespace stipple {

/// A patch is what values are at the 37 places of a square lattice within 3.5 spacings of a site.
constexpr int kSamples = 37;
constexpr float kPatchRadius = 3.5f;  // spacings
using SampleArray = Eigen::Array<float, kSamples, 1>;

/// Sites x channels.
using Features = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// How the samples of a patch come from sites: each is a mean of three. Samples that no site is near (at the
/// boundary of a scan) have weights of 0.
struct PatchStencil {
  std::array<Index, 3 * kSamples> sites;
  std::array<float, 3 * kSamples> weights;
  bool isWhole() const;
};

PatchStencil fitStencil(const TangentPlaces& surface, Index site);

/// Writes the samples, channel by channel: channels x 37 values.
void samplePatch(const PatchStencil& stencil, const Features& features, float* samples);

/// The same of one number a site.
SampleArray sampleNumber(const PatchStencil& stencil, std::span<const float> numbers);

/// Divided by their sum, where there is one.
SampleArray normalized(const SampleArray& weights);

}  // namespace stipple
