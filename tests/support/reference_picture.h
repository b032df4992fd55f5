#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "render/appearance/appearance.h"
#include "render/appearance/image.h"
#include "render/hierarchy/view.h"
#include "tests/support/ray_scenes.h"

namespace stipple {

inline constexpr float kNoDepth = std::numeric_limits<float>::infinity();

/// Where the ray through a position of the picture starts and goes; depth grows along View's z.
scenes::Ray rayThrough(const View& view, const glm::vec2& px);

/// The picture that splats should come close to, by pixel.
struct ReferencePicture {
  Image image;                     ///< mean of the samples in linear light, over the background
  std::vector<std::uint8_t> hits;  ///< samples that met the surface
  int samples = 0;                 ///< of a pixel
  std::vector<float> depth;        ///< of the ray through the pixel's center; kNoDepth where it misses
  std::vector<glm::vec3> normals;  ///< of the same, world, towards the viewer

  bool isCovered(std::size_t pixel) const { return hits[pixel] == samples; }
};

/// Casts samplesPerSide^2 rays a pixel; lit two-sided by light::shade, without eye-dome lighting.
ReferencePicture castPicture(const scenes::RaySurface& surface, const View& view,
                             const Appearance& appearance, int samplesPerSide);

}  // namespace stipple
