#include "core/points/point_set.h"

#include <gtest/gtest.h>

namespace stipple {
namespace {

TEST(PointSet, CopiesShareUntilOneWrites) {
  PointSet original({{0, 0, 0}, {1, 0, 0}});
  original.set("height", std::vector<float>{1, 2});
  PointSet copy = original;
  EXPECT_EQ(copy.values<float>("height").data(), original.values<float>("height").data());
  const ColumnId before = original.find("height")->column.id();
  copy.edit<float>("height")[0] = 7;
  EXPECT_EQ(original.values<float>("height")[0], 1);
  EXPECT_EQ(original.find("height")->column.id(), before);
  EXPECT_NE(copy.find("height")->column.id(), before);
}

TEST(PointSet, RemovingRowsKeepsTheOrderAndReindexesTriangles) {
  PointSet points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
  points.set("label", std::vector<std::int32_t>{10, 11, 12, 13, 14});
  points.setTriangles({{0, 1, 2}, {2, 3, 4}});
  points.removeRows(std::vector<Index>{1});
  EXPECT_EQ(points.size(), 4u);
  const auto labels = points.values<std::int32_t>("label");
  EXPECT_EQ(std::vector<std::int32_t>(labels.begin(), labels.end()), (std::vector<std::int32_t>{10, 12, 13, 14}));
  EXPECT_EQ(points.triangles(), (std::vector<Triangle>{{1, 2, 3}}));
}

}  // namespace
}  // namespace stipple
