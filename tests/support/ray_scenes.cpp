#include "tests/support/ray_scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "core/parallel.h"

namespace stipple::scenes {

namespace {

constexpr double kPi = std::numbers::pi;

Eigen::Vector3f toEigen(const glm::dvec3& v) {
  return {float(v.x), float(v.y), float(v.z)};
}

Rgba8 toColor(const glm::dvec3& albedo) {
  const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(255 * v)); };
  return {byte(albedo.x), byte(albedo.y), byte(albedo.z), 0};
}

/// `draw(random)` is a uniform random SurfacePoint.
template <class Draw>
SurfaceSamples sampleInBlocks(Index count, std::uint64_t seed, Draw draw) {
  SurfaceSamples samples;
  samples.positions.resize(count);
  samples.normals.resize(count);
  samples.colors.resize(count);
  parallelFor(count, 16384, [&](std::size_t begin, std::size_t end) {
    std::seed_seq sequence{seed, static_cast<std::uint64_t>(begin)};
    std::mt19937_64 random(sequence);
    for (std::size_t i = begin; i < end; ++i) {
      const SurfacePoint point = draw(random);
      samples.positions[i] = toEigen(point.position);
      samples.normals[i] = toEigen(point.normal);
      samples.colors[i] = toColor(point.albedo);
    }
  });
  return samples;
}

double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

glm::dvec3 randomDirection(std::mt19937_64& random) {
  const double z = uniform(random, -1, 1), angle = uniform(random, 0, 2 * kPi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// A checker in space, tinted by the position so that neighboring cells differ.
glm::dvec3 spaceChecker(const glm::dvec3& p) {
  // Off the origin: the faces of the cube and the poles of the sphere lie inside cells.
  const glm::dvec3 cell = glm::floor(5.0 * p + 0.3);
  const bool bright = static_cast<int>(cell.x + cell.y + cell.z) & 1;
  return (bright ? 1.0 : 0.35) * (0.6 + 0.3 * glm::clamp(p, -1.0, 1.0));
}

/// Where the ray is inside a sphere about the origin; nothing where it misses.
struct Span {
  double begin, end;
};
std::optional<Span> insideSphere(const Ray& ray, double radius) {
  const double b = glm::dot(ray.origin, ray.direction);
  const double discriminant = b * b - glm::dot(ray.origin, ray.origin) + radius * radius;
  if (discriminant <= 0) return std::nullopt;
  const double root = std::sqrt(discriminant);
  return Span{-b - root, -b + root};
}

namespace torus {

constexpr double kMajor = 1, kMinor = 0.45, kRipple = 0.02, kWavesU = 20, kWavesV = 12;

double minorRadius(double u, double v) {
  return kMinor + kRipple * std::sin(kWavesU * u) * std::sin(kWavesV * v);
}

/// Outward normal times the area element of (u, v).
glm::dvec3 areaNormal(double u, double v) {
  const double q = minorRadius(u, v);
  const double qu = kRipple * kWavesU * std::cos(kWavesU * u) * std::sin(kWavesV * v);
  const double qv = kRipple * kWavesV * std::sin(kWavesU * u) * std::cos(kWavesV * v);
  const double cu = std::cos(u), su = std::sin(u), cv = std::cos(v), sv = std::sin(v);
  const glm::dvec3 alongU(qu * cv * cu - (kMajor + q * cv) * su, qu * cv * su + (kMajor + q * cv) * cu,
                          qu * sv);
  const double radial = qv * cv - q * sv;
  const glm::dvec3 alongV(radial * cu, radial * su, qv * sv + q * cv);
  return glm::cross(alongU, alongV);
}

SurfacePoint at(double u, double v) {
  const double q = minorRadius(u, v), rho = kMajor + q * std::cos(v);
  const int cell =
      static_cast<int>(std::floor(u * 60 / (2 * kPi))) + static_cast<int>(std::floor(v * 30 / (2 * kPi)));
  const double k = cell & 1 ? 1 : 0.5;
  return {.position = {rho * std::cos(u), rho * std::sin(u), q * std::sin(v)},
          .normal = glm::normalize(areaNormal(u, v)),
          .albedo = {k * (0.5 + 0.45 * std::sin(9 * u)), k * (0.5 + 0.45 * std::sin(7 * v)), k * 0.6}};
}

/// Steps along the ray by a bound of the distance to the rippled surface.
std::optional<SurfacePoint> firstHit(const Ray& ray) {
  // |gradient| of (distance from the core circle - minorRadius): sqrt(1 + (.4 / .53)^2 + (.24 / .43)^2)
  // < 1.4.
  constexpr double kSteepness = 1.4, kTolerance = 1e-7;
  const std::optional<Span> span = insideSphere(ray, kMajor + kMinor + kRipple);
  if (!span) return std::nullopt;
  for (double t = std::max(span->begin, 0.0); t < span->end;) {
    const glm::dvec3 p = ray.origin + t * ray.direction;
    const double rho = std::hypot(p.x, p.y), fromCore = std::hypot(rho - kMajor, p.z);
    const double toShell = fromCore - kMinor - kRipple;
    if (toShell > kRipple) {
      t += toShell;
      continue;
    }
    const double u = std::atan2(p.y, p.x), v = std::atan2(p.z, rho - kMajor);
    const double gap = fromCore - minorRadius(u, v);
    if (gap < kTolerance) return at(u, v);
    t += gap / kSteepness;
  }
  return std::nullopt;
}

double area() {
  // The rule of rectangles converges faster than any power for periodic functions.
  constexpr int kSteps = 480;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j)
      sum += glm::length(areaNormal(2 * kPi * i / kSteps, 2 * kPi * j / kSteps));
  }
  return sum * std::pow(2 * kPi / kSteps, 2);
}

SurfacePoint draw(std::mt19937_64& random) {
  constexpr double kLargestElement = 1.0;  // of area; (1 + .47) * .47 * 1.4 bounds it
  while (true) {
    const double u = uniform(random, -kPi, kPi), v = uniform(random, -kPi, kPi);
    if (uniform(random, 0, kLargestElement) < glm::length(areaNormal(u, v))) return at(u, v);
  }
}

}  // namespace torus

namespace carved {

constexpr double kBall = 1.2;
constexpr double kFaceArea = 4 - kPi * (kBall * kBall - 1);
constexpr double kBallArea = 4 * kPi * kBall * kBall - 6 * 2 * kPi * kBall * (kBall - 1);

bool isInCube(const glm::dvec3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 1;
}

SurfacePoint onFace(const glm::dvec3& p, int axis) {
  glm::dvec3 normal(0);
  normal[axis] = p[axis] > 0 ? 1 : -1;
  return {p, normal, spaceChecker(p)};
}
SurfacePoint onBall(const glm::dvec3& p) {
  return {p, -glm::normalize(p), spaceChecker(p)};
}

std::optional<SurfacePoint> firstHit(const Ray& ray) {
  // Slabs: where the ray is inside the cube, and through which face it enters.
  double enter = -1e300, leave = 1e300;
  int face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double t0 = (-1 - ray.origin[axis]) / ray.direction[axis],
           t1 = (1 - ray.origin[axis]) / ray.direction[axis];
    if (t0 > t1) std::swap(t0, t1);
    if (t0 > enter) face = axis;
    enter = std::max(enter, t0);
    leave = std::min(leave, t1);
  }
  if (enter >= leave || leave <= 0) return std::nullopt;
  const glm::dvec3 atFace = ray.origin + enter * ray.direction;
  if (enter > 0 && glm::length(atFace) > kBall) return onFace(atFace, face);
  // Entered through a hole: the ball's far side, where that is inside the cube.
  const std::optional<Span> ball = insideSphere(ray, kBall);
  if (!ball || ball->end >= leave || ball->end <= 0) return std::nullopt;
  return onBall(ray.origin + ball->end * ray.direction);
}

SurfacePoint draw(std::mt19937_64& random) {
  while (uniform(random, 0, 6 * kFaceArea + kBallArea) < kBallArea) {
    while (true) {
      const glm::dvec3 p = kBall * randomDirection(random);
      if (isInCube(p)) return onBall(p);
    }
  }
  while (true) {
    const int face = static_cast<int>(random() % 6);
    glm::dvec3 p(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    p[face / 2] = face % 2 ? 1 : -1;
    if (glm::length(p) >= kBall) return onFace(p, face / 2);
  }
}

}  // namespace carved

template <class Draw>
Scene makeScene(std::string name, RaySurface surface, double area, Draw draw) {
  return {.name = std::move(name),
          .surface = std::move(surface),
          .area = area,
          .sample = [draw](Index n, std::uint64_t seed) { return sampleInBlocks(n, seed, draw); }};
}

}  // namespace

double Scene::spacing(Index count) const {
  return std::sqrt(area / count);
}

Scene checkeredSphere() {
  const auto at = [](const glm::dvec3& p) { return SurfacePoint{p, glm::normalize(p), spaceChecker(p)}; };
  const auto firstHit = [at](const Ray& ray) -> std::optional<SurfacePoint> {
    const std::optional<Span> span = insideSphere(ray, 1);
    if (!span || span->begin <= 0) return std::nullopt;
    return at(ray.origin + span->begin * ray.direction);
  };
  return makeScene("sphere", {firstHit, {{0, 0, 0}, 1}}, 4 * kPi,
                   [at](std::mt19937_64& random) { return at(randomDirection(random)); });
}

Scene rippledTorus() {
  constexpr auto kRadius = static_cast<float>(torus::kMajor + torus::kMinor + torus::kRipple);
  return makeScene("torus", {torus::firstHit, {{0, 0, 0}, kRadius}}, torus::area(), torus::draw);
}

Scene carvedCube() {
  return makeScene("carved cube", {carved::firstHit, {{0, 0, 0}, std::numbers::sqrt3_v<float>}},
                   6 * carved::kFaceArea + carved::kBallArea, carved::draw);
}

std::vector<Scene> allScenes() {
  return {checkeredSphere(), rippledTorus(), carvedCube()};
}

}  // namespace stipple::scenes
