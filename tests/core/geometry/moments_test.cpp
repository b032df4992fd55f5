#include "core/geometry/moments.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

constexpr double kPi = 3.14159265358979;

// Site next to the given place.
Index siteAt(const Sites& sites, const Eigen::Vector3f& place) {
  Index best = 0;
  for (Index i = 0; i < sites.size(); ++i) {
    if ((sites.positions[i] - place).squaredNorm() < (sites.positions[best] - place).squaredNorm()) best = i;
  }
  return best;
}

TEST(Moments, FlatDiscHasAQuarterOfItsSquaredRadius) {
  const Sites sites = weldAndOrder(shapes::grid(101));
  const auto moments = fitMoments(sites, findNeighborhoods(sites, {.k = 10, .epsilon = 0.1f, .cap = 100000}));
  const Moments& m = moments[siteAt(sites, {0.5f, 0.5f, 0})];
  EXPECT_NEAR(m.eigenvalues[0], 0.1f * 0.1f / 4, 3e-5);
  EXPECT_NEAR(m.eigenvalues[1], 0.1f * 0.1f / 4, 3e-5);
  EXPECT_NEAR(m.eigenvalues[2], 0, 1e-9);
  EXPECT_NEAR(std::abs(m.axes.col(2).z()), 1, 1e-6);
  EXPECT_NEAR(m.centerOffset.norm(), 0, 1e-3);  // ties at the rim of the disc go to one side
  EXPECT_NEAR(m.axes.determinant(), 1, 1e-5);
}

TEST(Moments, NormalOfASphereIsItsRadius) {
  const Sites sites = weldAndOrder(shapes::randomSphere(20000));
  const auto moments = fitMoments(sites, findNeighborhoods(sites, {.k = 30}));
  double worst = 1;
  for (Index i = 0; i < sites.size(); ++i) {
    worst = std::min<double>(worst, std::abs(moments[i].axes.col(2).dot(sites.positions[i])));
  }
  EXPECT_GT(worst, 0.995);
}

// C on a fold of turning angle phi: 1 / (1 + 141 sin^6(phi / 2)), up to 124 degrees.
TEST(Classifier, FollowsTheClosedFormOnACrease) {
  for (const double degrees : {20.0, 40.0, 60.0, 90.0}) {
    const double phi = degrees * kPi / 180;
    std::vector<Eigen::Vector3f> points;
    for (int x = -25; x <= 25; ++x) {
      for (int y = -25; y <= 25; ++y) {
        // Both halves are bent down by phi / 2 about the y axis.
        const double u = x * 0.04;
        points.emplace_back(static_cast<float>(u * std::cos(phi / 2)), static_cast<float>(y * 0.04),
                            static_cast<float>(-std::abs(u) * std::sin(phi / 2)));
      }
    }
    const Sites sites = weldAndOrder(points);
    const auto classifier =
        classify(fitMoments(sites, findNeighborhoods(sites, {.k = 10, .epsilon = 0.5f, .cap = 100000})));
    const double expected = 1 / (1 + 141 * std::pow(std::sin(phi / 2), 6));
    EXPECT_NEAR(classifier[siteAt(sites, {0, 0, 0})], expected, 0.02 + 0.05 * expected) << degrees;
  }
}

// C on a sphere: 1 / (1 + 4.34 (kappa eps)^6) to leading order.
TEST(Classifier, FollowsTheClosedFormOnASphere) {
  const Sites sites = weldAndOrder(shapes::randomSphere(20000));
  for (const float epsilon : {0.2f, 0.4f}) {
    const auto classifier =
        classify(fitMoments(sites, findNeighborhoods(sites, {.k = 10, .epsilon = epsilon, .cap = 100000})));
    double mean = 0;
    for (Index i = 0; i < sites.size(); i += 101) mean += classifier[i];
    mean /= (sites.size() + 100) / 101;
    EXPECT_NEAR(mean, 1 / (1 + 4.34 * std::pow(epsilon, 6)), 0.004) << epsilon;
  }
}

TEST(Classifier, DoesNotDependOnScaleAndStaysInItsRange) {
  auto points = shapes::randomSphere(3000);
  for (auto& p : points) p.z() = std::abs(p.z()) < 0.5f ? p.z() : 0.5f;
  const auto classify30 = [](const std::vector<Eigen::Vector3f>& at) {
    const Sites sites = weldAndOrder(at);
    return gatherToSites<float>(
        sites,
        scatterToPoints<float>(sites, classify(fitMoments(sites, findNeighborhoods(sites, {.k = 30})))));
  };
  const auto original = classify30(points);
  for (auto& p : points) p *= 1024.f;
  const auto scaled = classify30(points);
  for (std::size_t i = 0; i < original.size(); ++i) {
    EXPECT_NEAR(original[i], scaled[i], 1e-5);
    EXPECT_GT(original[i], 0);
    EXPECT_LE(original[i], 1);
  }
}

TEST(Classifier, DegenerateSetsAreFlat) {
  for (const std::size_t n : {1u, 2u, 3u}) {
    const Sites sites = weldAndOrder(shapes::randomSphere(n));
    for (const float c : classify(fitMoments(sites, findNeighborhoods(sites, {.k = 30}))))
      EXPECT_TRUE(c > 0 && c <= 1);
  }
}

TEST(Noise, IsMeasuredInSpacings) {
  for (const double level : {0.1, 0.3, 0.5}) {
    auto points = shapes::randomSphere(20000);
    const double spacing = std::sqrt(4 * kPi / 20000);
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal(0, level * spacing);
    for (auto& p : points) p *= static_cast<float>(1 + normal(random));
    EXPECT_NEAR(estimateNoise(weldAndOrder(points)), level, 0.15 * level) << level;
  }
  EXPECT_LT(estimateNoise(weldAndOrder(shapes::randomSphere(20000))), 0.01);
  EXPECT_EQ(estimateNoise(weldAndOrder(shapes::randomSphere(5))), 0);
}

}  // namespace
}  // namespace stipple
