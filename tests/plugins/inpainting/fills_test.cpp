#include "plugins/inpainting/fills.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace stipple
