#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "core/stopwatch.h"
#include "render/hierarchy/build.h"
#include "render/splat/cpu_renderer.h"
#include "tests/support/picture_errors.h"
#include "tests/support/ray_scenes.h"

namespace stipple {

struct BenchOptions {
  Index points = 10'000'000;
  int width = 1280, height = 720;
  int repetitions = 5;
};

/// What several measurements share, made when it is first needed: the torus, its samples, their hierarchy in
/// kd order.
class Workbench {
 public:
  explicit Workbench(const BenchOptions& asked) : options(asked) { appearance.edgeStrength = 0; }

  const BenchOptions options;
  const scenes::Scene torus = scenes::rippledTorus();
  Appearance appearance;  ///< without eye-dome lighting, which the references lack
  CpuRenderer renderer;

  const scenes::SurfaceSamples& samples();
  /// Radii and areas from blocks of leaves, as for a file that has just been opened.
  Hierarchy& hierarchy();
  const ReferencePicture& reference();

  /// All of the torus fills the picture, seen from above at a slant.
  View view(float turned = 0) const;

 private:
  std::optional<scenes::SurfaceSamples> samples_;
  std::optional<Hierarchy> hierarchy_;
  std::optional<ReferencePicture> reference_;
};

/// Smallest and middle of repeated times, in milliseconds.
class Times {
 public:
  void add(const Stopwatch& watch) {
    wall_.push_back(1e3 * watch.seconds());
    cpu_.push_back(1e3 * watch.cpuSeconds());
  }
  double least() const { return *std::ranges::min_element(wall_); }
  double median() const { return medianOf(wall_); }
  double medianCpu() const { return medianOf(cpu_); }

 private:
  static double medianOf(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
  }
  std::vector<double> wall_, cpu_;
};

/// The mean of jittered frames, as it is shown at rest.
void drawMeanOfFrames(Workbench& bench, const Hierarchy& hierarchy, const View& view, float tau, int frames);

/// One of 16 positions within the pixel, centered.
glm::vec2 jitterOf(int frame);

void printQuality(Workbench& bench);
void printSpeed(Workbench& bench);
void printPopping(Workbench& bench);
void printCoverage(Workbench& bench);
void printBuild(Workbench& bench);
void printRefit(Workbench& bench);
void printMemory(Workbench& bench);

}  // namespace stipple
