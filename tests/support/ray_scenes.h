#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/points/attribute.h"
#include "render/hierarchy/view.h"

/// Surfaces whose pictures are known: rays are cast at the analytic surface, and points are drawn from the
/// same.
namespace stipple::scenes {

struct Ray {
  glm::dvec3 origin{};
  glm::dvec3 direction{};  ///< unit
};

struct SurfacePoint {
  glm::dvec3 position{};
  glm::dvec3 normal{};  ///< unit, outwards
  glm::dvec3 albedo{};  ///< sRGB, 0 to 1
};

/// What rays meet first; may be called on several threads at once.
struct RaySurface {
  std::function<std::optional<SurfacePoint>(const Ray&)> firstHit;
  FramingSphere sphere;
};

struct SurfaceSamples {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<Rgba8> colors;  ///< alpha 0: not selected
};

struct Scene {
  std::string name;
  RaySurface surface;
  double area = 0;
  /// Uniform random points of the surface, independent of each other (so their order says nothing), with
  /// exact normals and colors. Same points for any number of threads.
  std::function<SurfaceSamples(Index count, std::uint64_t seed)> sample;

  /// Side of the square that a point stands for.
  double spacing(Index count) const;
};

/// Unit sphere, a checker in space of side 1/5.
Scene checkeredSphere();
/// Torus of radii 1 and 0.45 + 0.02 sin 20u sin 12v about the z axis, checker of 60 x 30 with colors along u
/// and v.
Scene rippledTorus();
/// The cube [-1, 1]^3 without the ball of radius 1.2 about its center: straight and round edges, sharp rims.
/// A checker in space of side 1/5.
Scene carvedCube();

std::vector<Scene> allScenes();

}  // namespace stipple::scenes
