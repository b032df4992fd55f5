#include "app/tools/inspection_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/shapes.h"

namespace stipple {
namespace {

using testing::HasSubstr;

std::vector<ColoredSegment> ofColor(const std::vector<ColoredSegment>& all, const Rgba8& color) {
  std::vector<ColoredSegment> some;
  for (const ColoredSegment& segment : all)
    if (segment.color == color) some.push_back(segment);
  return some;
}

TEST(InspectionDrawing, ShowsNeighborsFanAndFrame) {
  const PointSet points(shapes::randomSquare(3000));
  Index middle = 0;
  for (Index row = 0; row < points.size(); ++row) {
    const auto off = [&](Index r) { return (points.positions()[r] - Eigen::Vector3f(0.5f, 0.5f, 0)).norm(); };
    if (off(row) < off(middle)) middle = row;
  }
  const PointInspection inspection = inspectPoint(points, middle);
  const auto segments = segmentsOf(inspection, points);
  EXPECT_EQ(ofColor(segments, kNeighborColor).size(), 30u);
  EXPECT_EQ(ofColor(segments, kFanColor).size(), 3 * inspection.fan.size());

  const auto major = ofColor(segments, kMajorAxisColor), minor = ofColor(segments, kMinorAxisColor),
             normal = ofColor(segments, kNormalColor);
  ASSERT_EQ(major.size(), 1u);
  ASSERT_EQ(minor.size(), 1u);
  ASSERT_EQ(normal.size(), 1u);
  // An even disc has the eigenvalues radius^2 / 4.
  EXPECT_NEAR(glm::distance(major[0].from, major[0].to), inspection.moments.radius,
              0.35f * inspection.moments.radius);
  EXPECT_LE(glm::distance(minor[0].from, minor[0].to), glm::distance(major[0].from, major[0].to));
  const glm::vec3 up = glm::normalize(normal[0].to - normal[0].from);
  EXPECT_NEAR(up.z, inspection.normal.z(), 1e-4f);
}

TEST(InspectionDrawing, SaysTheNumbers) {
  const PointSet points(shapes::randomSphere(2000));
  const auto lines = linesOf(inspectPoint(points, 42));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_THAT(lines[0], HasSubstr("point 42: 30 neighbors"));
  EXPECT_THAT(lines[1], HasSubstr("classifier"));
  EXPECT_THAT(lines[3], HasSubstr("closed, certified"));
  EXPECT_THAT(lines[4], HasSubstr("mass"));
}

TEST(InspectionDrawing, ALonePointHasNumbersToo) {
  const PointSet points(std::vector<Eigen::Vector3f>{{1, 2, 3}});
  const PointInspection inspection = inspectPoint(points, 0);
  EXPECT_TRUE(ofColor(segmentsOf(inspection, points), kFanColor).empty());
  EXPECT_FALSE(linesOf(inspection).empty());
}

}  // namespace
}  // namespace stipple
