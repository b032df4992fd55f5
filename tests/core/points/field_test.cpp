#include "core/points/field.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace stipple {
namespace {

TEST(Field, EveryColorComesBackFromLinearLight) {
  for (int s = 0; s < 256; ++s) EXPECT_EQ(srgbOf(linearLightOf(static_cast<std::uint8_t>(s))), s);
  EXPECT_EQ(linearLightOf(0), 0);
  EXPECT_EQ(linearLightOf(255), 1);
  EXPECT_NEAR(linearLightOf(128), 0.2158605, 1e-6) << "IEC 61966-2-1";
  EXPECT_EQ(srgbOf(-1), 0);
  EXPECT_EQ(srgbOf(7), 255);
  EXPECT_EQ(srgbOf(std::numeric_limits<double>::quiet_NaN()), 0);
}

PointSet threePoints() {
  PointSet points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  points.set("color", std::vector<Rgba8>{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}});
  points.set("count", std::vector<std::int32_t>{-1, 0, 7});
  points.set("height", std::vector<float>{0.1f, 0.2f, 0.3f});
  points.set("along", std::vector<Eigen::Vector3f>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  return points;
}

TEST(Field, ReadsAndWritesTheRowsAskedForAndNoOther) {
  PointSet points = threePoints();
  const std::vector<Index> rows{2, 0};
  Attribute& color = *points.find("color");
  const Eigen::MatrixXd field = readField(color, rows);
  EXPECT_EQ(field(0, 2), linearLightOf(11));
  writeField(color, rows, Eigen::MatrixXd::Ones(2, 3));
  const auto colors = points.values<Rgba8>("color");
  EXPECT_EQ(colors[0], (Rgba8{255, 255, 255, 4})) << "alpha stays";
  EXPECT_EQ(colors[1], (Rgba8{5, 6, 7, 8}));
  EXPECT_EQ(readField(*points.find("along"), rows).row(0), Eigen::RowVector3d(0, 0, 1));
}

TEST(Field, NumbersAreRoundedClampedAndFinite) {
  PointSet points = threePoints();
  const std::vector<Index> rows{0, 1, 2};
  const Eigen::Vector3d values(2.6, -1e30, std::numeric_limits<double>::quiet_NaN());
  writeField(*points.find("count"), rows, values);
  writeField(*points.find("height"), rows, values);
  const auto counts = points.values<std::int32_t>("count");
  EXPECT_EQ(counts[0], 3);
  EXPECT_EQ(counts[1], std::numeric_limits<std::int32_t>::lowest());
  EXPECT_EQ(counts[2], 7);
  EXPECT_EQ(points.values<float>("height")[2], 0.3f);
}

}  // namespace
}  // namespace stipple
