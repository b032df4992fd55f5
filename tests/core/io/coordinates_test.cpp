#include "core/io/coordinates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace stipple {
namespace {

using testing::ElementsAre;

std::vector<Eigen::Vector3d> randomBox(const Eigen::Vector3d& center, double extent) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-extent / 2, extent / 2);
  std::vector<Eigen::Vector3d> points(1000);
  for (Eigen::Vector3d& point : points) {
    for (int axis = 0; axis < 3; ++axis) point[axis] = center[axis] + uniform(random);
  }
  return points;
}

double lossWith(const Eigen::Vector3d& origin, const std::vector<Eigen::Vector3d>& points) {
  double loss = 0;
  const std::vector<Eigen::Vector3f> positions = relativeTo(origin, points);
  for (std::size_t row = 0; row < points.size(); ++row) {
    loss = std::max(loss, (origin + positions[row].cast<double>() - points[row]).cwiseAbs().maxCoeff());
  }
  return loss;
}

TEST(ChooseOrigin, IsZeroWhereFloatsAreFineEnough) {
  EXPECT_EQ(chooseOrigin(randomBox({0, 0, 0}, 1e-3)), Eigen::Vector3d::Zero());
  EXPECT_EQ(chooseOrigin(randomBox({5, -3, 1}, 1)), Eigen::Vector3d::Zero());
  EXPECT_EQ(chooseOrigin({}), Eigen::Vector3d::Zero());
  // Numbers that are floats lose nothing, however far away they are.
  EXPECT_EQ(chooseOrigin(std::vector<Eigen::Vector3d>{{5648349, 1, 2}, {5648350, 1, 2}}),
            Eigen::Vector3d::Zero());
}

TEST(ChooseOrigin, FarAwayItKeepsEveryPointWithinAMillionthOfTheExtent) {
  for (const double extent : {1e-3, 0.7, 12.0, 900.0}) {
    const auto points = randomBox({665187.52, 5648349.9, -241.77}, extent);
    const Eigen::Vector3d origin = chooseOrigin(points);
    EXPECT_NE(origin, Eigen::Vector3d::Zero());
    EXPECT_LE(lossWith(origin, points), 1e-6 * extent) << extent;
    const double step = std::exp2(std::floor(std::log2(extent / 8)));
    for (const double value : origin) EXPECT_EQ(std::remainder(value, step), 0) << extent;
  }
}

TEST(ChooseOrigin, OnePlaceFarAway) {
  const std::vector<Eigen::Vector3d> points(3, Eigen::Vector3d(665187.522077, 5648349.895035, 241.767693));
  EXPECT_LT(lossWith(chooseOrigin(points), points), 1e-7);
}

TEST(RelativeTo, WhatIsBeyondFloatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const auto positions =
      relativeTo(Eigen::Vector3d::Zero(),
                 std::vector<Eigen::Vector3d>{
                     {1, 2, 3}, {nan, 0, 0}, {0, -infinity, 0}, {0, 0, 1e300}, {3e38, 3e38, 0}});
  EXPECT_THAT(rowsNotFinite(positions), ElementsAre(1, 2, 3));
}

TEST(FileCoordinate, KeepsTheSignOfZero) {
  EXPECT_TRUE(std::signbit(fileCoordinate(0, -0.0F)));
  EXPECT_EQ(fileCoordinate(1024, 0.5F), 1024.5);
}

}  // namespace
}  // namespace stipple
