#include "tests/support/coverage.h"

#include <gtest/gtest.h>

#include "render/splat/cpu_renderer.h"
#include "tests/support/sampled_hierarchy.h"
#include "tests/support/scans.h"
#include "tests/support/test_data.h"

// Splats of a dense scan leave no hole, and nothing behind shows through. The suite looks from few sides;
// tests named FromAllSides from 20 directions at three distances.

namespace stipple {
namespace {

constexpr int kStray = 3;  // pixels of a view

CoverageOptions fewViews() {
  return {.side = 240, .directions = 3, .zooms = {0.5f, 1.5f}};
}

void expectCovered(const CoverageSubject& subject, const CoverageOptions& options) {
  CpuRenderer renderer;
  const std::vector<CoverageView> views = lookFromAllSides(renderer, subject, options);
  for (const CoverageView& view : views) {
    ASSERT_GT(view.errors.covered, 500);
    EXPECT_LE(view.stray(), kStray) << describeWorst({view});
  }
}

/// Radii from local fans, as after the estimates of the first picture.
void expectSceneCovered(const scenes::Scene& scene, const CoverageOptions& options) {
  constexpr Index kCount = 60'000;
  const scenes::SurfaceSamples samples = scene.sample(kCount, 1);
  const Hierarchy hierarchy = buildByFans(samples.positions, samples.normals, samples.colors);
  expectCovered({hierarchy, scene.surface, static_cast<float>(scene.spacing(kCount))}, options);
}

void expectScanCovered(const char* name, const CoverageOptions& options) {
  const MeshSubject scan = loadMesh(testData(pathOfScan(name)));
  expectCovered({scan.byFans, scan.truth, scan.spacing}, options);
}

TEST(Coverage, OfTheSphere) {
  expectSceneCovered(scenes::checkeredSphere(), fewViews());
}
TEST(Coverage, OfTheTorus) {
  expectSceneCovered(scenes::rippledTorus(), fewViews());
}

TEST(Coverage, OfTheBunny) {
  STIPPLE_NEEDS_TEST_DATA();
  expectScanCovered("bunny", fewViews());
}
TEST(Coverage, OfTheAnkylosaurus) {
  STIPPLE_NEEDS_TEST_DATA();
  expectScanCovered("ankylosaurus", fewViews());
}

TEST(CoverageFromAllSides, OfTheSphere) {
  expectSceneCovered(scenes::checkeredSphere(), {});
}
TEST(CoverageFromAllSides, OfTheTorus) {
  expectSceneCovered(scenes::rippledTorus(), {});
}

class CoverageFromAllSides : public testing::TestWithParam<const char*> {};
TEST_P(CoverageFromAllSides, OfAScan) {
  STIPPLE_NEEDS_TEST_DATA();
  expectScanCovered(GetParam(), {});
}
INSTANTIATE_TEST_SUITE_P(Scans, CoverageFromAllSides,
                         testing::Values("bunny", "igea", "armadillo", "lion-head", "ankylosaurus"));

}  // namespace
}  // namespace stipple
