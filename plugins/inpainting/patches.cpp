#include "plugins/inpainting/patches.h"

#include <algorithm>
#include <limits>

namespace stipple {

namespace {

// Farther than this from every site, in spacings, there is no surface: among points thrown at random one
// place in a thousand is.
constexpr float kFarthest = 1.5f;
// Keeps the weights of a sample on top of a site finite, in spacings squared.
constexpr float kSoftening = 0.01f;

std::array<Eigen::Vector2f, kSamples> latticePlaces() {
  std::array<Eigen::Vector2f, kSamples> places;
  int count = 0;
  for (int v = -3; v <= 3; ++v) {
    for (int u = -3; u <= 3; ++u) {
      const Eigen::Vector2f place(static_cast<float>(u), static_cast<float>(v));
      if (place.norm() <= kPatchRadius) places[count++] = place;
    }
  }
  return places;
}
const std::array<Eigen::Vector2f, kSamples> kLattice = latticePlaces();

}  // namespace

bool PatchStencil::isWhole() const {
  for (int s = 0; s < kSamples; ++s) {
    if (!(weights[3 * s] > 0)) return false;
  }
  return true;
}

PatchStencil fitStencil(const TangentPlaces& surface, Index site) {
  const std::span<const Index> neighbors = surface.of(site);
  const auto count = static_cast<Eigen::Index>(neighbors.size());
  const auto places = Eigen::Matrix2Xf::Map(surface.placesOf(site).data()->data(), 2, count);
  const Eigen::ArrayXf u = places.row(0), v = places.row(1);
  Eigen::ArrayXf distances(count);
  PatchStencil stencil;
  for (int s = 0; s < kSamples; ++s) {
    distances = (u - kLattice[s].x()).square() + (v - kLattice[s].y()).square();
    // The three nearest, insertion by insertion.
    constexpr float kNone = std::numeric_limits<float>::infinity();
    std::array<float, 3> squared{kLattice[s].squaredNorm(), kNone, kNone};
    std::array<Index, 3> nearest{site, site, site};
    for (Eigen::Index n = 0; n < count; ++n) {
      if (!(distances[n] < squared[2])) continue;
      int rank = 2;
      for (; rank > 0 && distances[n] < squared[rank - 1]; --rank) {
        squared[rank] = squared[rank - 1];
        nearest[rank] = nearest[rank - 1];
      }
      squared[rank] = distances[n];
      nearest[rank] = neighbors[static_cast<std::size_t>(n)];
    }
    const bool isSurface = squared[0] <= kFarthest * kFarthest;
    Eigen::Array3f weights = Eigen::Array3f::Zero();
    if (isSurface) weights = (Eigen::Array3f::Map(squared.data()) + kSoftening).inverse();
    if (isSurface) weights /= weights.sum();
    for (int r = 0; r < 3; ++r) {
      stencil.sites[3 * s + r] = nearest[r];
      stencil.weights[3 * s + r] = weights[r];
    }
  }
  return stencil;
}

void samplePatch(const PatchStencil& stencil, const Features& features, float* samples) {
  for (Eigen::Index c = 0; c < features.cols(); ++c) {
    for (int s = 0; s < kSamples; ++s) {
      float sum = 0;
      for (int r = 3 * s; r < 3 * s + 3; ++r) sum += stencil.weights[r] * features(stencil.sites[r], c);
      samples[c * kSamples + s] = sum;
    }
  }
}

SampleArray sampleNumber(const PatchStencil& stencil, std::span<const float> numbers) {
  SampleArray samples;
  for (int s = 0; s < kSamples; ++s) {
    samples[s] = 0;
    for (int r = 3 * s; r < 3 * s + 3; ++r) samples[s] += stencil.weights[r] * numbers[stencil.sites[r]];
  }
  return samples;
}

SampleArray normalized(const SampleArray& weights) {
  const float sum = weights.sum();
  return sum > 0 ? SampleArray(weights / sum) : weights;
}

}  // namespace stipple
