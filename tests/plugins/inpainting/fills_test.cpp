#include "plugins/inpainting/fills.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/plugins/inpainting/inpaint_points.h"

namespace stipple {
namespace {

// Long waves: a harmonic fill of a quadric of this curvature in a hole of this radius is off by .0111, as in
// the table that these bars come from: half the Laplacian over 4, times the radius squared, times sqrt(1/3).
double smooth(const Eigen::Vector3f& p) {
  const double x = p.x() - 0.5, y = p.y() - 0.5;
  return 0.5 + 0.33 * std::cos(2.5 * x + 0.3) * std::cos(2.5 * y - 0.2);
}
double stepEdge(const Eigen::Vector3f& p) {
  return 0.8 * (p.x() - 0.49) + 0.6 * (p.y() - 0.5) > 0 ? 1 : 0;
}
double linear(const Eigen::Vector3f& p) {
  return 0.3 * p.x() - 0.5 * p.y() + 1;
}

double stripes(const Eigen::Vector3f& p) {
  return std::sin(2 * std::numbers::pi * (p.x() + 0.3 * p.y()) / 0.12) > 0 ? 1 : 0;
}
// Grain without any structure: a hash of the position, uniform in [-.2, .2].
double grain(const Eigen::Vector3f& p) {
  const double hash = std::sin(127.1 * p.x() + 311.7 * p.y()) * 43758.5453;
  return 0.4 * (hash - std::floor(hash)) - 0.2;
}

// Root mean square over samples of the square.
double error(const Texture& texture, const char* method) {
  constexpr std::uint64_t kSamples = 6;
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= kSamples; ++seed) sum += std::pow(holeError(texture, method, seed), 2);
  return std::sqrt(sum / kSamples);
}

TEST(Fills, ErrorsInAHoleOfTwelveSpacings) {
  EXPECT_LT(error(smooth, "harmonic"), 0.0111);
  EXPECT_LT(error(smooth, "biharmonic"), 0.0006);
  EXPECT_LT(error(smooth, "tensor"), 0.0111);
  EXPECT_LT(error(stepEdge, "harmonic"), 0.26);
  EXPECT_LT(error(stepEdge, "biharmonic"), 0.236);
  EXPECT_LT(error(stepEdge, "tensor"), 0.142);
  for (const char* method : {"harmonic", "biharmonic", "tensor"})
    EXPECT_LT(error(linear, method), 1e-4) << method;
}

// Edges go on through a grain and close to each other; a grain alone has none.
TEST(Fills, EdgesGoOnGrainDoesNot) {
  const auto grainyEdge = [](const Eigen::Vector3f& p) { return stepEdge(p) + grain(p); };
  EXPECT_LT(error(grainyEdge, "tensor"), 0.75 * error(grainyEdge, "harmonic"));
  EXPECT_LT(error(stripes, "tensor"), 0.55 * error(stripes, "harmonic"));
  EXPECT_LT(error(grain, "tensor"), 1.02 * error(grain, "harmonic"));
}

}  // namespace
}  // namespace stipple
