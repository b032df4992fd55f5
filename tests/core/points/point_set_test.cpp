#include "core/points/point_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/identical.h"

namespace stipple {
namespace {

using testing::ElementsAre;

template <class Call>
std::string sentenceOf(Call call) {
  try {
    call();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

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
  EXPECT_EQ(std::vector<std::int32_t>(labels.begin(), labels.end()),
            (std::vector<std::int32_t>{10, 12, 13, 14}));
  EXPECT_EQ(points.triangles(), (std::vector<Triangle>{{1, 2, 3}}));
}

TEST(PointSet, NamesTheAttributeThatIsMissingOrOfAnotherType) {
  PointSet points({{0, 0, 0}});
  points.set("height", std::vector<float>{1});
  EXPECT_EQ(sentenceOf([&] { points.values<float>("depth"); }), "there is no attribute 'depth'");
  EXPECT_EQ(sentenceOf([&] { points.values<double>("height"); }),
            "attribute 'height' is of type float, expected double");
  EXPECT_EQ(sentenceOf([&] {
              points.set("height", std::vector<float>{1, 2});
            }),
            "attribute 'height' has 2 values, expected 1");
  EXPECT_EQ(sentenceOf([&] {
              points.setTriangles({{0, 0, 0}, {0, 1, 0}});
            }),
            "triangle 1 names point 1, expected below 1");
}

TEST(PointSet, KeepsTheFilePropertyOfAnAttributeWhileItsTypeStays) {
  PointSet points({{0, 0, 0}});
  points.set("q", std::vector<std::int32_t>{1}, {"scalar_q", ScalarType::kInt8});
  points.set("q", std::vector<std::int32_t>{2});
  EXPECT_EQ(points.find("q")->file, (FileProperty{"scalar_q", ScalarType::kInt8}));
  points.set("q", std::vector<double>{2});
  EXPECT_EQ(points.find("q")->file, (FileProperty{"", ScalarType::kFloat64}));
}

TEST(PointSet, KeepsTheOrderOfItsAttributes) {
  PointSet points({{0, 0, 0}});
  const auto names = [&points] {
    std::vector<std::string> list;
    for (const Attribute& attribute : points.attributes()) list.push_back(attribute.name);
    return list;
  };
  points.set("a", std::vector<float>{1});
  points.set("b", std::vector<float>{1});
  points.insert({"c", Column(std::vector<float>{1}), {}}, 1);
  points.set("a", std::vector<double>{1});
  EXPECT_THAT(names(), ElementsAre("a", "c", "b"));
  EXPECT_TRUE(points.erase("c"));
  EXPECT_FALSE(points.erase("c"));
  EXPECT_THAT(names(), ElementsAre("a", "b"));
}

TEST(PointSet, AppendsRowsWithZerosAndWhiteForWhatTheyLack) {
  PointSet points({{0, 0, 0}});
  points.set("label", std::vector<std::int32_t>{4});
  points.set("color", std::vector<Rgba8>{{1, 2, 3, 4}});
  points.set("normal", std::vector<Eigen::Vector3f>{{0, 0, 1}});
  PointSet more({{5, 5, 5}, {6, 6, 6}});
  more.set("label", std::vector<std::int32_t>{8, 9});
  more.set("normal", std::vector<double>{1, 2});  // of another type: as if it lacked it
  more.set("unknown", std::vector<float>{1, 2});
  const ColumnId topology = points.topologyId();
  points.appendRows(more);
  EXPECT_NE(points.topologyId(), topology);
  EXPECT_THAT(points.values<std::int32_t>("label"), ElementsAre(4, 8, 9));
  EXPECT_THAT(points.values<Rgba8>("color"),
              ElementsAre(Rgba8{1, 2, 3, 4}, Rgba8{255, 255, 255, 255}, Rgba8{255, 255, 255, 255}));
  EXPECT_EQ(points.values<Eigen::Vector3f>("normal")[2], Eigen::Vector3f(0, 0, 0));
  EXPECT_EQ(points.positions()[1], Eigen::Vector3f(5, 5, 5));
  EXPECT_FALSE(points.has("unknown"));
}

TEST(PointSet, AppendsItself) {
  PointSet points({{0, 0, 0}, {1, 0, 0}});
  points.set("label", std::vector<std::int32_t>{4, 5});
  points.appendRows(points);
  EXPECT_THAT(points.values<std::int32_t>("label"), ElementsAre(4, 5, 4, 5));
  EXPECT_EQ(points.positions()[3], Eigen::Vector3f(1, 0, 0));
}

TEST(PointSet, RefusesRowsThatDoNotFitAndStaysAsItWas) {
  PointSet points({{0, 0, 0}, {1, 0, 0}});
  points.set("label", std::vector<std::int32_t>{4, 5});
  const PointSet before = points;
  EXPECT_EQ(sentenceOf([&] {
              points.removeRows(std::vector<Index>{0, 2});
            }),
            "row 1 to remove is 2, expected ascending and below 2");
  EXPECT_EQ(sentenceOf([&] {
              points.appendRows(PointSet({{0, 0, 0}}, {1, 0, 0}));
            }),
            "appended points have another origin");
  EXPECT_TRUE(identical(points, before));
  EXPECT_EQ(points.topologyId(), before.topologyId());
}

}  // namespace
}  // namespace stipple
