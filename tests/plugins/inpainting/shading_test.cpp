// Light whose law is known on shapes that are known: what the fill has to find inside a mask.
#include "plugins/inpainting/shading.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "core/points/field.h"
#include "plugins/inpainting/fills.h"
#include "plugins/inpainting/relief.h"
#include "tests/plugins/inpainting/inpaint_points.h"
#include "tests/support/cancel_after.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

constexpr int kSide = 100;
constexpr Rgba8 kLost{255, 0, 255, 255};

// Waves z = a sin(k x) sin(k y) over the unit square, two to the width of the hole.
struct Waves {
  double amplitude;
  double wave = 2 * std::numbers::pi / 0.12;

  Eigen::Vector3d at(double x, double y) const {
    return {x, y, amplitude * std::sin(wave * x) * std::sin(wave * y)};
  }
  Eigen::Vector3d normal(double x, double y) const {
    return Eigen::Vector3d(-amplitude * wave * std::cos(wave * x) * std::sin(wave * y),
                           -amplitude * wave * std::sin(wave * x) * std::cos(wave * y), 1)
        .normalized();
  }
};

using Paint = std::function<double(double x, double y, const Eigen::Vector3d& normal)>;

// Waves on which linear light follows a law, and a hole in the middle.
struct Lit {
  std::vector<double> light;
  PointSet points;
  std::vector<Index> masked;

  Lit(double amplitude, const Paint& paint) {
    const Waves waves{amplitude};
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> shake(-0.3 / kSide, 0.3 / kSide);
    std::vector<Eigen::Vector3f> positions;
    std::vector<Rgba8> colors;
    for (const Eigen::Vector3f& p : shapes::grid(kSide)) {
      const double x = p.x() + shake(random), y = p.y() + shake(random);
      positions.push_back(waves.at(x, y).cast<float>());
      light.push_back(paint(x, y, waves.normal(x, y)));
      const std::uint8_t gray = srgbOf(light.back());
      colors.push_back({gray, gray, gray, 255});
    }
    points = PointSet(positions);
    masked = rowsAround(points, {0.5f, 0.5f, 0}, 0.12f);
    for (const Index row : masked) colors[row] = kLost;
    points.set("color", colors);
  }
  // Root mean square, in linear light.
  double errorOf(const char* method) const {
    const PointSet filled = inpaint(points, masked, {{"method", std::string(method)}});
    double sum = 0;
    for (const Index row : masked)
      sum += std::pow(linearLightOf(filled.values<Rgba8>("color")[row].g) - light[row], 2);
    return std::sqrt(sum / static_cast<double>(masked.size()));
  }
  Hole hole() const {
    Progress progress;
    return prepareHole(points, *points.find("color"), regionOfRows(points, masked), {}, progress);
  }
};

// Lambert's law under one lamp and some light from everywhere.
double lambert(const Eigen::Vector3d& normal) {
  return 0.2 + 0.6 * std::max(0.0, normal.dot(Eigen::Vector3d(0.7, 0.2, 0.7).normalized()));
}

TEST(Shading, FollowsTheReliefIntoTheHole) {
  const Lit matt(0.01, [](double, double, const Eigen::Vector3d& n) { return lambert(n); });
  EXPECT_LT(matt.errorOf("tensor"), 0.25 * matt.errorOf("harmonic"));
  // What the surface is painted with need not be even.
  const Lit painted(0.01, [](double x, double y, const Eigen::Vector3d& n) {
    return (0.4 + 0.4 * x + 0.2 * y) * lambert(n);
  });
  EXPECT_LT(painted.errorOf("tensor"), 0.25 * painted.errorOf("harmonic"));
}

TEST(Shading, IsTakenOffAndPutOn) {
  const Lit matt(0.01, [](double, double, const Eigen::Vector3d& n) { return lambert(n); });
  const Hole hole = matt.hole();
  const Shading shading(hole);
  Eigen::MatrixXd colors = hole.values;
  shading.takeOff(colors);
  // All known points are of one paint.
  const auto spread = [&](const Eigen::MatrixXd& values) {
    std::vector<double> known;
    for (Index site = 0; site < hole.discretization.size(); ++site) {
      const Eigen::Vector3f& p = hole.discretization.sites.positions[site];
      const float distance = std::hypot(p.x() - 0.5f, p.y() - 0.5f);
      if (distance > 0.13f && distance < 0.18f) known.push_back(values(site, 0));
    }
    const Eigen::Map<const Eigen::ArrayXd> a(known.data(), static_cast<Eigen::Index>(known.size()));
    return std::sqrt((a - a.mean()).square().mean());
  };
  EXPECT_LT(spread(colors), 0.2 * spread(hole.values));
  shading.putOn(colors);
  EXPECT_LT((colors - hole.values).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Shading, AStepThatIsCancelledLeavesTheLight) {
  const Lit matt(0.01, [](double, double, const Eigen::Vector3d& n) { return lambert(n); });
  Hole hole = matt.hole();
  const Progress progress;
  TensorFill fill(hole, progress);
  fill.step(hole, progress);
  const Eigen::MatrixXd before = hole.values;
  const CancelAfter cancel(0);
  EXPECT_THROW(fill.step(hole, cancel), Cancelled);
  EXPECT_LT((hole.values - before).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Shading, AFlatPlaceHasNone) {
  const Lit flat(0, [](double x, double y, const Eigen::Vector3d&) {
    return 0.5 + 0.3 * std::sin(20 * x) * std::cos(17 * y);
  });
  const Hole hole = flat.hole();
  Eigen::MatrixXd colors = hole.values;
  Shading(hole).takeOff(colors);
  EXPECT_LT((colors - hole.values).cwiseAbs().maxCoeff(), 1e-6);
}

// A pattern that runs across the waves as it likes: the fill is as good as without any light.
TEST(Shading, PaintThatDoesNotFollowTheReliefIsNotTakenForLight) {
  const Lit checkers(0.01, [](double x, double y, const Eigen::Vector3d&) {
    return 0.5 + 0.3 * std::sin(31 * x + 12 * y) * std::sin(37 * y - 9 * x);
  });
  EXPECT_LT(checkers.errorOf("tensor"), 1.1 * checkers.errorOf("harmonic"));
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> any(0.2, 0.8);
  const Lit noise(0.01, [&](double, double, const Eigen::Vector3d&) { return any(random); });
  const Hole hole = noise.hole();
  Eigen::MatrixXd colors = hole.values;
  Shading(hole).takeOff(colors);
  EXPECT_LT(std::sqrt((colors - hole.values).cwiseAbs2().mean()), 0.02);
}

TEST(Shading, NumbersHaveNone) {
  Lit matt(0.01, [](double, double, const Eigen::Vector3d& n) { return lambert(n); });
  matt.points.set("light", matt.light);
  Progress progress;
  const Hole hole = prepareHole(matt.points, *matt.points.find("light"),
                                regionOfRows(matt.points, matt.masked), {}, progress);
  Eigen::MatrixXd values = hole.values;
  Shading(hole).takeOff(values);
  EXPECT_EQ(values, hole.values);
}

// Heights are in spacings; a turn of the whole turns the harmonics and leaves the heights.
TEST(Relief, DependsOnTheShapeAlone) {
  const Waves waves{0.01};
  std::vector<Eigen::Vector3f> small, large;
  for (const Eigen::Vector3f& p : shapes::grid(60)) {
    small.push_back(waves.at(p.x(), p.y()).cast<float>());
    large.push_back(Eigen::Vector3f(64 * small.back()));
  }
  Progress progress;
  const Discretization a = discretize(PointSet(small), {}, progress),
                       b = discretize(PointSet(large), {}, progress);
  const Relief reliefA = describeRelief(a), reliefB = describeRelief(b);
  for (Index site = 0; site < a.size(); ++site) {
    ASSERT_EQ(a.sites.pointOfSite[site], b.sites.pointOfSite[site]);
    const double sign = reliefA.row(site).head<3>().dot(reliefB.row(site).head<3>()) > 0 ? 1 : -1;
    ASSERT_LT((reliefA.row(site).tail<3>() - sign * reliefB.row(site).tail<3>()).norm(), 1e-5);
  }
}

// On a sphere of radius R the mean of six neighbors at distance d and the site lies 6/7 d^2 / (2 R) below.
TEST(Relief, StandsOutOfASphereAsItsCurvatureSays) {
  std::vector<Eigen::Vector3f> positions;
  constexpr int kCount = 20000;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < kCount; ++i) {
    const double z = 1 - (2 * i + 1.0) / kCount, r = std::sqrt(1 - z * z);
    positions.push_back(Eigen::Vector3d(r * std::cos(golden * i), r * std::sin(golden * i), z).cast<float>());
  }
  Progress progress;
  const Discretization d = discretize(PointSet(positions), {}, progress);
  const Relief relief = describeRelief(d);
  const double spacing = std::sqrt(4 * std::numbers::pi / kCount);
  double found = 0, wantedSum = 0;
  for (Index site = 0; site < d.size(); ++site) {
    double squares = 0;
    for (const Index j : d.fans.of(site))
      squares += (d.sites.positions[j] - d.sites.positions[site]).cast<double>().squaredNorm();
    const double wanted = squares / 2 / static_cast<double>(d.fans.of(site).size() + 1) / spacing;
    const Eigen::Vector3d n = relief.row(site).head<3>();
    const double outside = n.dot(d.sites.positions[site].cast<double>());
    ASSERT_NEAR(std::abs(outside), 1, 1e-3);
    // The normal of a fan leans a little, and with it what its uneven middle stands out.
    ASSERT_NEAR(relief(site, 8) * outside, wanted, 0.25 * wanted);
    found += relief(site, 8) * outside;
    wantedSum += wanted;
  }
  EXPECT_NEAR(found, wantedSum, 0.01 * wantedSum);
}

}  // namespace
}  // namespace stipple
