#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render/appearance/light.h"
#include "render/hierarchy/closedness.h"
#include "render/hierarchy/hidden_nodes.h"
#include "render/hierarchy/splat_radii.h"
#include "tests/bench/render/naive_points.h"
#include "tests/bench/render/workbench.h"
#include "tests/support/sampled_hierarchy.h"

namespace stipple {

namespace {

constexpr Index kMostFans = 3'000'000;  // as in the window: larger ones keep the radii of blocks

struct Case {
  const scenes::Scene& scene;
  const scenes::SurfaceSamples& samples;
  View view;
  const ReferencePicture& reference;

  float spacing() const {
    return static_cast<float>(scene.spacing(static_cast<Index>(samples.positions.size())));
  }
};

PictureErrors drawOnce(Workbench& bench, const Case& c, const Hierarchy& hierarchy, float tau) {
  const Cut cut = selectCut(hierarchy, c.view, {.tau = tau});
  bench.renderer.draw(hierarchy, cut.nodes, c.view, bench.appearance, Accumulate::kStartAnew, nullptr);
  return comparePictures(c.reference, takePicture(bench.renderer), 3 * c.spacing());
}

PictureErrors drawMean(Workbench& bench, const Case& c, const Hierarchy& hierarchy, float tau) {
  drawMeanOfFrames(bench, hierarchy, c.view, tau, 16);
  return comparePictures(c.reference, takePicture(bench.renderer), 3 * c.spacing());
}

/// Degrees between the blended normals and those of the surface, from a picture whose colors are normals.
struct NormalErrors {
  double mean = 0, worstHundredth = 0;
};
NormalErrors compareNormals(Workbench& bench, const Case& c) {
  std::vector<Rgba8> colors(c.samples.normals.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const Eigen::Vector3f linear = 0.5f * c.samples.normals[i] + Eigen::Vector3f::Constant(0.5f);
    colors[i] = {encodeSrgb(linear.x()), encodeSrgb(linear.y()), encodeSrgb(linear.z()), 0};
  }
  LeafAttributes leaves = leavesOf(c.samples);
  leaves.colors = colors;
  const Hierarchy hierarchy = buildHierarchy(leaves, LeafOrder::kKd);
  bench.renderer.upload(hierarchy, {{0, hierarchy.nodeCount()}});
  Appearance unlit = bench.appearance;
  unlit.lit = false;
  const Cut cut = selectCut(hierarchy, c.view, {.tau = 3});
  bench.renderer.draw(hierarchy, cut.nodes, c.view, unlit, Accumulate::kStartAnew, nullptr);
  const Image image = bench.renderer.image();

  std::vector<double> degrees;
  double sum = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (!c.reference.isCovered(i)) continue;
    const Rgba8 p = image.pixels[i];
    const glm::vec3 normal =
        2.f * glm::vec3(linearTable()[p.r], linearTable()[p.g], linearTable()[p.b]) - 1.f;
    const float cosine = std::abs(glm::dot(glm::normalize(normal), c.reference.normals[i]));
    degrees.push_back(std::acos(std::min(cosine, 1.f)) * 180 / M_PI);
    sum += degrees.back();
  }
  const auto hundredth = degrees.begin() + static_cast<std::ptrdiff_t>(0.99 * degrees.size());
  std::nth_element(degrees.begin(), hundredth, degrees.end());
  return {sum / degrees.size(), *hundredth};
}

void printRow(const Case& c, const std::string& what, const PictureErrors& e, double naive) {
  fmt::print("{:<12} {:>9} {:<22} {:>6.2f} {:>6.2f} {:>6.3f} {:>+6.2f} {:>5} {:>4} {:>6} {:>7.4f}%\n",
             c.scene.name, c.samples.positions.size(), what, e.psnr, e.psnrWithEdges, e.ssim, e.psnr - naive,
             e.holes, e.seeThrough, e.fringe, 100. * e.fringe / e.covered);
}

void printCase(Workbench& bench, const Case& c) {
  NaivePoints naive(c.samples, {});
  naive.draw(c.view, *bench.appearance.background);
  const PictureErrors naiveErrors = comparePictures(c.reference, naive.picture(), kNoDepth);
  printRow(c, "naive", naiveErrors, naiveErrors.psnr);

  // What the surface itself shows through the centers of the pixels: the limit of a picture without a filter.
  const ReferencePicture exact = castPicture(c.scene.surface, c.view, bench.appearance, 1);
  printRow(c, "exact, a ray a pixel", comparePictures(c.reference, {exact.image, exact.depth}, kNoDepth),
           naiveErrors.psnr);

  LeafAttributes leaves = leavesOf(c.samples);
  const auto draw = [&](const char* origin) {
    Hierarchy hierarchy = buildHierarchy(leaves, LeafOrder::kKd);
    bench.renderer.upload(hierarchy, {{0, hierarchy.nodeCount()}});
    for (const float tau : {2.f, 3.f, 6.f}) {
      printRow(c, fmt::format("tau {} {}", tau, origin), drawOnce(bench, c, hierarchy, tau),
               naiveErrors.psnr);
    }
    hierarchy.isClosedAndOriented = isClosedAndOriented(PointSet(c.samples.positions), hierarchy);
    const Cut cut = selectCut(hierarchy, c.view, {.tau = 3});
    bench.renderer.draw(hierarchy, cut.nodes, c.view, bench.appearance, Accumulate::kStartAnew, nullptr);
    const float tau =
        tauOfMean(3, withoutHidden(hierarchy, cut.nodes, c.view, bench.renderer.depth()).size());
    printRow(c, fmt::format("tau {:.2g} x 16 {}", tau, origin), drawMean(bench, c, hierarchy, tau),
             naiveErrors.psnr);
  };
  draw("blocks");
  if (c.samples.positions.size() <= kMostFans) {
    PointSet points(c.samples.positions);
    points.set("normal", c.samples.normals);
    const SurfaceEstimate estimate = estimateSurface(points);
    leaves.radii = estimate.radii;
    leaves.areas = estimate.areas;
    draw("fans");
  }
  const NormalErrors normals = compareNormals(bench, c);
  fmt::print("{:<12} {:>9} normals at tau 3: mean {:.2f} degrees, 99 % within {:.2f}\n", c.scene.name,
             c.samples.positions.size(), normals.mean, normals.worstHundredth);
  std::fflush(stdout);
}

}  // namespace

void printQuality(Workbench& bench) {
  fmt::print("{:<12} {:>9} {:<22} {:>6} {:>6} {:>6} {:>6} {:>5} {:>4} {:>6} of covered\n", "scene", "points",
             "", "PSNR", "edges", "SSIM", "gain", "holes", "back", "fringe");
  for (const scenes::Scene& scene : scenes::allScenes()) {
    const View view = frameView(scene.surface.sphere, {.yaw = 0.3f, .pitch = 0.67f}, bench.options.width,
                                bench.options.height);
    const ReferencePicture reference = castPicture(scene.surface, view, bench.appearance, 4);
    for (const Index count : {bench.options.points / 10, bench.options.points}) {
      const scenes::SurfaceSamples samples = scene.sample(count, 1);
      printCase(bench, {scene, samples, view, reference});
    }
  }
}

}  // namespace stipple
