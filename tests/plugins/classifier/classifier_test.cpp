#include "plugins/classifier/classifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/creased_shapes.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

std::vector<float> classifierOf(const PointSet& points, std::int64_t k) {
  const std::unique_ptr<Operator> classifier = makeClassifier();
  Parameters parameters(classifier->description().parameters);
  parameters.set("k", k);
  Progress progress;
  const auto run = classifier->start(points, Region(), parameters);
  EXPECT_TRUE(run->step(progress).finished);
  const PointSet result = run->result().points;
  const auto values = result.values<float>("classifier");
  return {values.begin(), values.end()};
}

double medianOf(std::vector<float> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// C = 1 / (1 + 141 sin^6(phi / 2)) on a crease of turning angle phi: exact moments of two half discs.
TEST(Classifier, OnACreaseItIsTheClosedForm) {
  for (const double degrees : {40.0, 60.0, 90.0}) {
    const double turn = degrees * std::numbers::pi / 180;
    const shapes::FacedPoints fold = shapes::foldedSquare(turn, 40000, 3);
    const std::vector<float> c = classifierOf(PointSet(fold.positions), 60);
    // Points within a fifth of a spacing of the crease: those near both planes.
    std::vector<float> onCrease;
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(0.7 + 3, Eigen::Vector3d(1, 2, 0.5).normalized()).toRotationMatrix();
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Eigen::Vector3d p = rotation.transpose() * fold.positions[i].cast<double>();
      const double fromCrease = std::hypot(p.x(), p.z());
      if (fromCrease < 0.001 && p.y() > 0.1 && p.y() < 0.9) onCrease.push_back(c[i]);
    }
    ASSERT_GT(onCrease.size(), 40u);
    const double expected = 1 / (1 + 141 * std::pow(std::sin(turn / 2), 6));
    EXPECT_NEAR(medianOf(onCrease), expected, 0.05) << degrees << " degrees";
  }
}

// C = 1 / (1 + 4.34 (kappa eps)^6) on a sphere: leading order for small kappa eps.
TEST(Classifier, OnASphereItIsTheClosedForm) {
  for (const std::int64_t k : {30, 60}) {
    const std::vector<float> c = classifierOf(PointSet(shapes::randomSphere(2500)), k);
    const double eps2 = 4.0 * (static_cast<double>(k) + 1) / 2500;  // area of the cap is that of k + 1 points
    EXPECT_NEAR(medianOf(c), 1 / (1 + 4.34 * std::pow(eps2, 3)), 0.01) << k;
  }
}

TEST(Classifier, APlaneIsFlatAndScaleDoesNotMatter) {
  std::vector<Eigen::Vector3f> plane = shapes::randomSquare(3000);
  for (const float value : classifierOf(PointSet(plane), 30)) EXPECT_FLOAT_EQ(value, 1);
  const shapes::FacedPoints fold = shapes::foldedSquare(1, 3000, 5);
  std::vector<Eigen::Vector3f> large = fold.positions;
  for (Eigen::Vector3f& p : large) p *= 1024;
  EXPECT_EQ(classifierOf(PointSet(fold.positions), 30), classifierOf(PointSet(large), 30));
}

TEST(Classifier, ARadiusWidensTheNeighborhood) {
  const std::unique_ptr<Operator> classifier = makeClassifier();
  Parameters parameters(classifier->description().parameters);
  parameters.set("epsilon", 0.4);
  Progress progress;
  const auto run = classifier->start(PointSet(shapes::randomSphere(2000)), Region(), parameters);
  run->step(progress);
  const PointSet result = run->result().points;
  const auto values = result.values<float>("classifier");
  EXPECT_NEAR(medianOf({values.begin(), values.end()}), 1 / (1 + 4.34 * std::pow(0.4, 6)), 0.005);
}

TEST(Classifier, DegenerateSetsAreFlat) {
  EXPECT_EQ(classifierOf(PointSet({{1, 2, 3}}), 30), std::vector<float>{1});
  const std::vector<Eigen::Vector3f> copies(7, Eigen::Vector3f(4, 5, 6));
  EXPECT_EQ(classifierOf(PointSet(copies), 30), std::vector<float>(7, 1.f));
}

}  // namespace
}  // namespace stipple
