#include "tests/support/ray_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "tests/support/mesh_caster.h"
#include "tests/support/reference_picture.h"

namespace stipple::scenes {
namespace {

constexpr double kPi = std::numbers::pi;

glm::dvec3 randomUnit(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return glm::normalize(glm::dvec3(x, y, z));
}

glm::dvec3 toGlm(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

/// Inside is negative.
double torusLevel(const glm::dvec3& p) {
  const double rho = std::hypot(p.x, p.y), u = std::atan2(p.y, p.x), v = std::atan2(p.z, rho - 1);
  return std::hypot(rho - 1, p.z) - 0.45 - 0.02 * std::sin(20 * u) * std::sin(12 * v);
}
double carvedCubeLevel(const glm::dvec3& p) {
  const double cube = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 1;
  return std::max(cube, 1.2 - glm::length(p));
}

/// First change of sign along the ray in steps of 1/2000; negative where there is none.
template <class Level>
double marchedDistance(const Ray& ray, Level level) {
  for (double t = 0; t < 8; t += 0.0005) {
    if (level(ray.origin + t * ray.direction) < 0) return t;
  }
  return -1;
}

template <class Level>
void expectHitsWhereMarching(const Scene& scene, Level level) {
  std::mt19937_64 random(7);
  int met = 0;
  for (int i = 0; i < 400; ++i) {
    const glm::dvec3 origin = 3.0 * randomUnit(random), target = 1.2 * randomUnit(random);
    const Ray ray{origin, glm::normalize(target - origin)};
    const auto hit = scene.surface.firstHit(ray);
    const double marched = marchedDistance(ray, level);
    if (!hit) {
      EXPECT_LT(marched, 0) << i;
      continue;
    }
    ++met;
    EXPECT_NEAR(level(hit->position), 0, 1e-6) << i;
    EXPECT_LT(glm::dot(hit->normal, ray.direction), 1e-3) << i;
    // Marching may step over a corner that the ray cuts off by less than a step.
    if (marched >= 0) {
      EXPECT_LE(glm::distance(hit->position, origin), marched + 1e-6) << i;
    }
    if (glm::distance(hit->position, origin) < marched - 0.001) {
      EXPECT_GE(level(hit->position + 0.0005 * ray.direction), -5e-4) << i;
    }
  }
  EXPECT_GT(met, 100);
}

TEST(RayScenes, TorusIsHitWhereMarchingMeetsItsLevelSet) {
  expectHitsWhereMarching(rippledTorus(), torusLevel);
}

TEST(RayScenes, CarvedCubeIsHitWhereMarchingMeetsItsLevelSet) {
  expectHitsWhereMarching(carvedCube(), carvedCubeLevel);
}

TEST(RayScenes, RaysFindSamplesWithTheirNormalsAndColors) {
  for (const Scene& scene : allScenes()) {
    const SurfaceSamples samples = scene.sample(3000, 5);
    int strangers = 0;
    for (std::size_t i = 0; i < samples.positions.size(); ++i) {
      const glm::dvec3 p = toGlm(samples.positions[i]), n = glm::normalize(toGlm(samples.normals[i]));
      const auto hit = scene.surface.firstHit({p + 1e-3 * n, -n});
      ASSERT_TRUE(hit) << scene.name << " " << i;
      EXPECT_LT(glm::distance(hit->position, p), 2e-6) << scene.name;
      EXPECT_GT(glm::dot(hit->normal, n), 1 - 1e-5) << scene.name;
      const Rgba8 c = samples.colors[i];
      strangers += glm::distance(255.0 * hit->albedo, glm::dvec3(c.r, c.g, c.b)) > 2;
    }
    EXPECT_LE(strangers, 3) << scene.name << ": rounding may cross a border of the checker";
  }
}

TEST(RayScenes, NormalsAreAcrossTheTorusLevelSet) {
  const SurfaceSamples samples = rippledTorus().sample(1000, 6);
  for (std::size_t i = 0; i < samples.positions.size(); ++i) {
    const glm::dvec3 p = toGlm(samples.positions[i]);
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0);
      step[axis] = 1e-5;
      gradient[axis] = torusLevel(p + step) - torusLevel(p - step);
    }
    EXPECT_GT(glm::dot(glm::normalize(gradient), toGlm(samples.normals[i])), 1 - 1e-5);
  }
}

/// Share of samples that `isInside` accepts, against area over the whole area: within five standard
/// deviations.
template <class Inside>
void expectShare(const Scene& scene, double area, Inside isInside) {
  constexpr Index kCount = 400'000;
  const SurfaceSamples samples = scene.sample(kCount, 11);
  const auto inside =
      std::ranges::count_if(samples.positions, [&](const auto& p) { return isInside(toGlm(p)); });
  const double expected = kCount * area / scene.area;
  EXPECT_NEAR(static_cast<double>(inside), expected, 5 * std::sqrt(expected)) << scene.name;
}

TEST(RayScenes, SamplesAreUniform) {
  expectShare(checkeredSphere(), 2 * kPi * 0.1, [](const glm::dvec3& p) { return p.z > 0.9; });
  const Scene cube = carvedCube();
  expectShare(cube, 0.15 * 0.15,
              [](const glm::dvec3& p) { return p.z > 1 - 1e-6 && p.x > 0.85 && p.y > 0.85; });
  expectShare(cube, 2 * kPi * 1.44 * (1 - std::cos(0.3)), [](const glm::dvec3& p) {
    return glm::length(p) < 1.2 + 1e-6 &&
           glm::dot(p, glm::dvec3(1)) > 1.2 * std::numbers::sqrt3 * std::cos(0.3);
  });
  // A patch of the torus between angles, its area from small triangles of the level set's parametrization.
  double area = 0;
  const auto at = [](double u, double v) {
    const double q = 0.45 + 0.02 * std::sin(20 * u) * std::sin(12 * v), rho = 1 + q * std::cos(v);
    return glm::dvec3(rho * std::cos(u), rho * std::sin(u), q * std::sin(v));
  };
  constexpr int kSteps = 600;
  const double h = 0.5 / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const glm::dvec3 a = at(i * h, j * h), b = at((i + 1) * h, j * h), c = at(i * h, (j + 1) * h);
      area += glm::length(glm::cross(b - a, c - a));
    }
  }
  expectShare(rippledTorus(), area, [](const glm::dvec3& p) {
    const double u = std::atan2(p.y, p.x), v = std::atan2(p.z, std::hypot(p.x, p.y) - 1);
    return u > 0 && u < 0.5 && v > 0 && v < 0.5;
  });
}

TEST(MeshCaster, FindsTheNearestOfAllTriangles) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<Eigen::Vector3f> corners(900);
  for (Eigen::Vector3f& p : corners) p = {uniform(random), uniform(random), uniform(random)};
  PointSet soup(corners);
  std::vector<Triangle> triangles;
  for (Index i = 0; i + 2 < soup.size(); i += 3) triangles.push_back({i, i + 1, i + 2});
  soup.setTriangles(triangles);
  const RaySurface all = castMesh(soup);
  std::vector<RaySurface> single;
  for (const Triangle& t : triangles) {
    PointSet one({corners[t[0]], corners[t[1]], corners[t[2]]});
    one.setTriangles({{0, 1, 2}});
    single.push_back(castMesh(one));
  }
  for (int i = 0; i < 200; ++i) {
    const Ray ray{3.0 * randomUnit(random), randomUnit(random)};
    double nearest = 1e9;
    for (const RaySurface& one : single) {
      if (const auto hit = one.firstHit(ray))
        nearest = std::min(nearest, glm::distance(hit->position, ray.origin));
    }
    const auto hit = all.firstHit(ray);
    ASSERT_EQ(hit.has_value(), nearest < 1e9) << i;
    if (hit) {
      EXPECT_DOUBLE_EQ(glm::distance(hit->position, ray.origin), nearest);
    }
  }
}

TEST(ReferencePicture, OfASphereHasItsAreaAndDepth) {
  const Scene scene = checkeredSphere();
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    const View view =
        frameView(scene.surface.sphere, {.yaw = 0.4f, .pitch = 0.3f, .projection = projection}, 201, 201);
    const ReferencePicture picture = castPicture(scene.surface, view, {}, 4);
    double covered = 0;
    for (const std::uint8_t hits : picture.hits) covered += hits / 16.0;
    EXPECT_NEAR(covered, kPi * 100.5 * 100.5, 0.002 * covered);  // the sphere just fits the height
    const std::size_t middle = 100 * 201 + 100;
    EXPECT_NEAR(picture.depth[middle], glm::length(view.eye) - 1, 1e-5);
    EXPECT_LT(glm::distance(view.viewFromWorld * picture.normals[middle], {0, 0, -1}), 1e-5);
    EXPECT_EQ(picture.depth[0], kNoDepth);
    EXPECT_EQ(picture.image.pixels[0], *Appearance{}.background);
  }
}

}  // namespace
}  // namespace stipple::scenes
