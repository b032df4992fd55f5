#include "plugins/editing/editing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "core/io/point_io.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"
#include "tests/support/undoable.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;
using Settings = std::vector<std::pair<std::string, ParameterValue>>;

RunResult runOperator(const Operator& op, const PointSet& points, const Settings& settings = {},
                      const Region& region = {}) {
  Parameters parameters(op.description().parameters);
  for (const auto& [id, value] : settings) parameters.set(id, value);
  const auto run = op.start(points, region, parameters);
  Progress progress;
  EXPECT_TRUE(run->step(progress).finished);
  return run->result();
}

// Six points on a line, numbered, with two triangles.
PointSet line() {
  PointSet points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}}, {100, 0, 0});
  points.set("number", std::vector<std::int32_t>{0, 1, 2, 3, 4, 5});
  points.setTriangles({{0, 1, 2}, {3, 4, 5}});
  return points;
}

TEST(DeletePoints, RemovesTheRegionAndItsTriangles) {
  const PointSet points = line();
  const RunResult result = runOperator(*makeDeletePoints(), points, {}, Region(points, {1, 0, 0, 1, 0, 0}));
  EXPECT_THAT(result.points.values<std::int32_t>("number"), ElementsAre(1, 2, 4, 5));
  EXPECT_THAT(result.removedRows, ElementsAre(0u, 3u));
  EXPECT_TRUE(result.points.triangles().empty());
  expectUndoable(points, result);
  EXPECT_THAT(
      [&] {
        runOperator(*makeDeletePoints(), points, {}, Region(points, {1, 1, 1, 1, 1, 1}));
      },
      ThrowsMessage<InvalidInput>(HasSubstr("this would remove all points")));
}

TEST(Crop, KeepsABoxInFileCoordinates) {
  const PointSet points = line();
  const Settings box{{"box", std::string("101.5,-1,-1, 104.5,1,1")}};
  const RunResult inside = runOperator(*makeCrop(), points, box);
  EXPECT_THAT(inside.points.values<std::int32_t>("number"), ElementsAre(2, 3, 4));
  Settings inverted = box;
  inverted.emplace_back("invert", true);
  EXPECT_THAT(runOperator(*makeCrop(), points, inverted).points.values<std::int32_t>("number"),
              ElementsAre(0, 1, 5));
  const RunResult both = runOperator(*makeCrop(), points, box, Region(points, {1, 1, 1, 0, 0, 0}));
  EXPECT_THAT(both.points.values<std::int32_t>("number"), ElementsAre(2));
  expectUndoable(points, inside);
}

TEST(Crop, SaysWhatIsWrong) {
  const PointSet points = line();
  const auto cropping = [&](const char* box) {
    return [&points, box] { runOperator(*makeCrop(), points, {{"box", std::string(box)}}); };
  };
  EXPECT_THAT(cropping(""), ThrowsMessage<InvalidInput>(HasSubstr("give a box, or a region")));
  for (const char* box : {"1,2,3", "1,2,3,4,5,x", "1,2,3,4,5,6,7", "nan,0,0,1,1,1", "1 2 3 4 5 6"})
    EXPECT_THAT(cropping(box), ThrowsMessage<InvalidInput>(HasSubstr("expected six numbers"))) << box;
  EXPECT_THAT(cropping("0,0,0,1,1,1"), ThrowsMessage<InvalidInput>(HasSubstr("remove all points")));
}

TEST(RemoveOutliers, TakesStrayPointsAndSpecksOnly) {
  std::vector<Eigen::Vector3f> positions = shapes::randomSphere(5000);
  const std::size_t clean = positions.size();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<float> far(1.3f, 4);
  for (int i = 0; i < 40; ++i) positions.push_back(far(random) * positions[100 * i]);
  for (int i = 0; i < 5; ++i) positions.push_back(Eigen::Vector3f(0, 0, 0.001f * static_cast<float>(i)));
  const PointSet points(positions);
  const RunResult result = runOperator(*makeRemoveOutliers(), points);
  EXPECT_TRUE(std::ranges::all_of(result.removedRows, [&](Index row) { return row >= clean; }));
  EXPECT_GE(result.removedRows.size(), 44u);
  expectUndoable(points, result);
}

// Dense and sparse parts are all right: what counts is what is usual where a point lies.
TEST(RemoveOutliers, LeavesScansOfAnyDensity) {
  STIPPLE_NEEDS_TEST_DATA();
  for (const char* file : {"smooth/bunny_adaptive.off", "smooth/igea_134k.ply", "smooth/kitten.xyz",
                           "smooth/armadillo_43k.obj", "cad/fandisk.off", "open/lion-head.off"}) {
    Progress progress;
    const PointSet points = readPoints(testData(file), progress).points;
    EXPECT_TRUE(runOperator(*makeRemoveOutliers(), points).removedRows.empty()) << file;
  }
}

TEST(Resample, LeavesAnEvenSubsetThatCoversEverything) {
  PointSet points(shapes::randomSquare(20'000));
  std::vector<std::int32_t> numbers(points.size());
  for (Index row = 0; row < points.size(); ++row) numbers[row] = static_cast<std::int32_t>(row);
  points.set("number", numbers);
  constexpr float kSpacing = 0.03f;
  const RunResult result = runOperator(*makeResample(), points, {{"spacing", double{kSpacing}}});
  const auto kept = result.points.positions();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) ASSERT_GT((kept[i] - kept[j]).norm(), 0.999f * kSpacing);
  }
  for (const Eigen::Vector3f& p : points.positions()) {
    float nearest = 1;
    for (const Eigen::Vector3f& q : kept) nearest = std::min(nearest, (p - q).norm());
    ASSERT_LE(nearest, 1.001f * kSpacing);
  }
  const auto rows = result.points.values<std::int32_t>("number");
  EXPECT_TRUE(std::ranges::is_sorted(rows)) << "the order of the file";
  for (std::size_t i = 0; i < kept.size(); ++i) ASSERT_EQ(kept[i], points.positions()[rows[i]]);
  expectUndoable(points, result);
}

TEST(Resample, ByDefaultAboutAQuarterStays) {
  std::vector<Eigen::Vector3f> grid = shapes::grid(60);
  grid.insert(grid.end(), grid.begin(), grid.end());
  const PointSet points(grid);
  const RunResult result = runOperator(*makeResample(), points);
  EXPECT_NEAR(result.points.size() / 3600.0, 0.25, 0.08);
}

TEST(EstimateNormals, OfASphereAllPointOutwards) {
  std::vector<Eigen::Vector3f> positions = shapes::randomSphere(4000);
  positions.push_back(positions[0]);
  const RunResult result = runOperator(*makeEstimateNormals(), PointSet(positions));
  const auto normals = result.points.values<Eigen::Vector3f>("normal");
  for (std::size_t i = 0; i < positions.size(); ++i) ASSERT_GT(normals[i].dot(positions[i]), 0.98f) << i;
}

TEST(EstimateNormals, KeepsTheSidesOfTheFileWhereAsked) {
  const std::vector<Eigen::Vector3f> positions = shapes::randomSphere(2000);
  std::vector<Eigen::Vector3f> inwards = positions;
  for (Eigen::Vector3f& n : inwards) n = -n;
  PointSet points(positions);
  points.set("normal", inwards);
  for (const bool keeps : {true, false}) {
    const RunResult result = runOperator(*makeEstimateNormals(), points, {{"keep_sides", keeps}});
    EXPECT_EQ(result.points.values<Eigen::Vector3f>("normal")[7].dot(positions[7]) < 0, keeps);
  }
  std::vector<std::uint8_t> mask(points.size(), 0);
  mask[3] = 1;
  const RunResult one = runOperator(*makeEstimateNormals(), points, {}, Region(points, mask));
  EXPECT_EQ(one.points.values<Eigen::Vector3f>("normal")[2], inwards[2]);
  EXPECT_NE(one.points.values<Eigen::Vector3f>("normal")[3], inwards[3]);
}

TEST(FlipNormals, TurnsThoseOfTheRegion) {
  PointSet points = line();
  EXPECT_THAT([&] { runOperator(*makeFlipNormals(), points); },
              ThrowsMessage<InvalidInput>(HasSubstr("no normals to flip")));
  points.set("normal", std::vector<Eigen::Vector3f>(6, {0, 0, 1}));
  const RunResult result = runOperator(*makeFlipNormals(), points, {}, Region(points, {0, 1, 0, 0, 0, 0}));
  const auto normals = result.points.values<Eigen::Vector3f>("normal");
  EXPECT_EQ(normals[0].z(), 1);
  EXPECT_EQ(normals[1].z(), -1);
}

class Transfer : public testing::Test {
 protected:
  std::string write(const PointSet& points) {
    Progress progress;
    writePoints(folder_.path() / "other.ply", points, {}, progress);
    return (folder_.path() / "other.ply").string();
  }
  TemporaryFolder folder_;
};

TEST_F(Transfer, TakesColorsBitForBitAndLeavesWhatIsFar) {
  PointSet other({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {100, 0, 0});
  other.set("color", std::vector<Rgba8>{{1, 2, 3, 255}, {40, 50, 60, 255}, {7, 8, 9, 255}});
  other.set("height", std::vector<float>{0.5f, 1.5f, 2.5f});
  const std::string file = write(other);
  const PointSet points = line();
  const RunResult all = runOperator(*makeTransferAttributes(), points, {{"from", file}});
  EXPECT_EQ(all.points.values<Rgba8>("color")[1], (Rgba8{40, 50, 60, 255}));
  EXPECT_EQ(all.points.values<float>("height")[5], 2.5f);
  EXPECT_EQ(all.points.values<std::int32_t>("number")[5], 5);
  const RunResult some =
      runOperator(*makeTransferAttributes(), points,
                  {{"from", file}, {"attributes", std::string(" height ")}, {"max_distance", 0.5}});
  EXPECT_FALSE(some.points.has("color"));
  EXPECT_THAT(some.points.values<float>("height"), ElementsAre(0.5f, 1.5f, 2.5f, 0, 0, 0));
  expectUndoable(points, all);
}

TEST_F(Transfer, SaysWhatIsWrong) {
  PointSet other({{0, 0, 0}});
  other.set("number", std::vector<float>{1});
  const std::string file = write(other);
  const auto taking = [&](const Settings& settings) {
    return [settings] { runOperator(*makeTransferAttributes(), line(), settings); };
  };
  EXPECT_THAT(taking({}), ThrowsMessage<InvalidInput>(HasSubstr("give the file")));
  EXPECT_THAT(taking({{"from", file + "x"}}), ThrowsMessage<Error>(HasSubstr("other.plyx")));
  EXPECT_THAT(taking({{"from", file}}),
              ThrowsMessage<InvalidInput>(HasSubstr("\"number\" has another type")));
  EXPECT_THAT(taking({{"from", file}, {"attributes", std::string("tone")}}),
              ThrowsMessage<InvalidInput>(HasSubstr("there is no attribute \"tone\"")));
}

TEST(Editing, OddSetsAreHandled) {
  const std::vector<Eigen::Vector3f> copies(40, Eigen::Vector3f(1, 2, 3));
  for (const auto& positions : {copies, shapes::randomSphere(1), shapes::randomSphere(3)}) {
    const PointSet points(positions);
    for (const auto& op : {makeRemoveOutliers(), makeResample(), makeEstimateNormals()}) {
      try {
        const RunResult result = runOperator(*op, points);
        EXPECT_GE(result.points.size(), 1u);
        if (!result.points.has("normal")) continue;
        for (const Eigen::Vector3f& n : result.points.values<Eigen::Vector3f>("normal"))
          EXPECT_TRUE(n.allFinite());
      } catch (const Error& error) {
        EXPECT_STRNE(error.what(), "");
      }
    }
  }
}

}  // namespace
}  // namespace stipple
