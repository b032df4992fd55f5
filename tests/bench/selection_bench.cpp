#include <benchmark/benchmark.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "app/tools/view_selection.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

// Half of a sphere of points is seen; the depth is that of the sphere.
struct Scene {
  std::vector<Eigen::Vector3f> positions;
  View view = frameView({{0, 0, 0}, 1}, {.yaw = 0.4f, .pitch = 0.3f}, 1600, 1000);
  std::vector<float> depth;

  explicit Scene(std::size_t count) : positions(shapes::randomSphere(count)) {
    depth.assign(std::size_t{1600} * 1000, std::numeric_limits<float>::infinity());
    const glm::vec3 center = view.toView({0, 0, 0});
    for (std::size_t pixel = 0; pixel < depth.size(); ++pixel) {
      const glm::vec2 px(static_cast<float>(pixel % 1600) + 0.5f, static_cast<float>(pixel / 1600) + 0.5f);
      const glm::vec3 ray = view.fromPixels(px, 1);
      const float a = glm::dot(ray, ray), b = glm::dot(ray, center);
      const float root = b * b - a * (glm::dot(center, center) - 1);
      if (root > 0) depth[pixel] = (b - std::sqrt(root)) / a;
    }
  }
};

const Scene& sceneOf(std::size_t count) {
  static const Scene kScene(count);
  return kScene;
}

SeenPoints seen(const Scene& scene) {
  return {.positions = scene.positions, .view = scene.view, .depth = scene.depth, .tolerance = 0.002f};
}

void findRectangle(benchmark::State& state) {
  const Scene& scene = sceneOf(10'000'000);
  for (auto _ : state)
    benchmark::DoNotOptimize(findInRectangle(seen(scene), {{100, 100}, {1500, 900}}).size());
}
BENCHMARK(findRectangle)->Unit(benchmark::kMillisecond)->UseRealTime();

void findLasso(benchmark::State& state) {
  const Scene& scene = sceneOf(10'000'000);
  std::vector<glm::vec2> lasso;
  for (int i = 0; i < 500; ++i) {
    const float angle = static_cast<float>(i) * 0.0125664f, radius = 300 + 100 * std::sin(7 * angle);
    lasso.emplace_back(800 + radius * std::cos(angle), 500 + radius * std::sin(angle));
  }
  for (auto _ : state) benchmark::DoNotOptimize(findInLasso(seen(scene), lasso).size());
}
BENCHMARK(findLasso)->Unit(benchmark::kMillisecond)->UseRealTime();

void findClick(benchmark::State& state) {
  const Scene& scene = sceneOf(10'000'000);
  for (auto _ : state) benchmark::DoNotOptimize(findClicked(seen(scene), {700, 450}));
}
BENCHMARK(findClick)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace stipple
