#include "plugins/segmentation/segmentation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/plugins/segmentation/segment_points.h"
#include "tests/support/cancel_after.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::ThrowsMessage;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

// Labels spreading from the middle of one side of a fold.
std::vector<std::int32_t> segmentFold(const shapes::FacedPoints& fold, double creaseAngle) {
  PointSet points(fold.positions);
  points.set("seeds", seedInFirstFace(fold, 7));
  return segmentsOf(points, {{"seeds", std::string("seeds")}, {"crease_angle", creaseAngle}});
}

TEST(Segmentation, CreasesSharperThanTheSettingAreSealedAndBlunterOnesCrossed) {
  for (const double setting : {45.0, 60.0, 90.0}) {
    for (const std::uint64_t seed : {1, 2}) {
      const shapes::FacedPoints sharp = shapes::foldedSquare(radians(setting + 10), 4900, seed);
      const shapes::FacedPoints blunt = shapes::foldedSquare(radians(setting - 20), 4900, seed);
      const std::vector<std::int32_t> sealed = segmentFold(sharp, setting),
                                      crossed = segmentFold(blunt, setting);
      EXPECT_GT(shareOfFace(sealed, sharp.faces, 0, 7), 0.97) << setting;
      EXPECT_LT(shareOfFace(sealed, sharp.faces, 1, 7), 0.01) << setting;
      EXPECT_GT(shareOfFace(crossed, blunt.faces, 1, 7), 0.97) << setting;
    }
  }
}

// Beyond 124 degrees the classifier takes a blade for a flat place.
TEST(Segmentation, BladesAreSealedToo) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const shapes::FacedPoints blade = shapes::foldedSquare(radians(135), 4900, seed);
    EXPECT_LT(shareOfFace(segmentFold(blade, 60), blade.faces, 1, 7), 0.01) << seed;
  }
}

TEST(Segmentation, NoiseOpensNoCrease) {
  const shapes::FacedPoints fold = shapes::foldedSquare(radians(70), 4900, 2, 0.2);
  const std::vector<std::int32_t> labels = segmentFold(fold, 60);
  EXPECT_GT(shareOfFace(labels, fold.faces, 0, 7), 0.95);
  EXPECT_LT(shareOfFace(labels, fold.faces, 1, 7), 0.03);
}

TEST(Segmentation, ACubeHasSixFaces) {
  const shapes::FacedPoints cube = shapes::randomCube(20000, 1);
  Report report;
  const PointSet result = segmentPoints(PointSet(cube.positions), {{"fill", true}}, &report);
  const auto labels = result.values<std::int32_t>("segment");
  const Score found = score({labels.begin(), labels.end()}, cube.faces);
  EXPECT_EQ(found.segments, 6);
  EXPECT_EQ(found.facesFound, 6);
  EXPECT_GT(found.purity, 0.99);
  EXPECT_EQ(found.labelled, 1);
  for (int label = 1; label < 6; ++label) {
    EXPECT_GE(std::count(labels.begin(), labels.end(), label),
              std::count(labels.begin(), labels.end(), label + 1));
  }
  EXPECT_EQ(std::get<std::int64_t>(report.values.front().second), 6);
}

TEST(Segmentation, SameBitsForAnyNumberOfThreads) {
  const PointSet cube(shapes::randomCube(6000, 3).positions);
  const auto run = [&](int threads) {
    const ThreadLimit limit(threads);
    return segmentPoints(cube, {});
  };
  const PointSet one = run(1), many = run(4);
  EXPECT_TRUE(sameBits(one.find("segment")->column.values(), many.find("segment")->column.values()));
  EXPECT_TRUE(
      sameBits(one.find("segment_signal")->column.values(), many.find("segment_signal")->column.values()));
}

TEST(Segmentation, GivenSeedsKeepTheirLabelsAndShareAFlatPlaceFairly) {
  PointSet points(shapes::grid(61));
  std::vector<std::int32_t> seeds(points.size(), 0);
  seeds[30 * 61 + 15] = -12;
  seeds[30 * 61 + 45] = 40;
  points.set("seeds", seeds);
  const PointSet result = segmentPoints(points, {{"seeds", std::string("seeds")}});
  const auto labels = result.values<std::int32_t>("segment");
  const auto signal = result.values<float>("segment_signal");
  // The places are mirror images: the border is the middle column.
  int wrong = 0;
  for (Index i = 0; i < points.size(); ++i) {
    const int column = static_cast<int>(i % 61);
    if (column < 28 && labels[i] != -12) ++wrong;
    if (column > 32 && labels[i] != 40) ++wrong;
    EXPECT_GE(signal[i], 0);
    EXPECT_LE(signal[i], 1);
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(labels[30 * 61 + 15], -12);
  EXPECT_EQ(signal[30 * 61 + 15], 1);
}

TEST(Segmentation, CopiesOfAPlaceGetOneLabelAndRowsKeepTheirOrder) {
  shapes::FacedPoints cube = shapes::randomCube(6000, 5);
  std::vector<Eigen::Vector3f> positions = cube.positions;
  positions.insert(positions.end(), cube.positions.begin(), cube.positions.end());
  const std::vector<std::int32_t> labels = segmentsOf(PointSet(positions), {});
  for (std::size_t i = 0; i < 6000; ++i) EXPECT_EQ(labels[i], labels[i + 6000]);
  EXPECT_GT(score({labels.begin(), labels.begin() + 6000}, cube.faces).purity, 0.98);
}

TEST(Segmentation, StepsPauseCancelAndTakeNewParameters) {
  const shapes::FacedPoints cube = shapes::randomCube(6000, 2);
  const auto run = makeSegmentation()->start(PointSet(cube.positions), Region(), segmentationSettings({}));
  EXPECT_FALSE(run->result().points.has("segment")) << "the snapshot before the first step";
  Progress progress;
  EXPECT_FALSE(run->step(progress).finished);
  const PointSet first = run->result().points;
  const CancelAfter cancel(0);
  Progress& stopped = const_cast<CancelAfter&>(cancel);
  EXPECT_THROW(run->step(stopped), Cancelled);
  EXPECT_TRUE(sameBits(first.find("segment")->column.values(),
                       run->result().points.find("segment")->column.values()));

  run->set(segmentationSettings({{"fill", true}}));
  double fraction = 0;
  for (StepState state; fraction < 1; fraction = state.fraction) {
    state = run->step(progress);
    EXPECT_GE(state.fraction, 0);
    EXPECT_LE(state.fraction, 1);
    EXPECT_EQ(state.finished, state.fraction == 1);
  }
  const PointSet filled = run->result().points;
  EXPECT_THAT(filled.values<std::int32_t>("segment"), Each(testing::Ne(0)));

  // With nothing sealed the closed surface is one segment.
  run->set(segmentationSettings({{"crease_angle", 130.0}}));
  while (!run->step(progress).finished) {
  }
  const PointSet whole = run->result().points;
  EXPECT_THAT(whole.values<std::int32_t>("segment"), Each(testing::Le(1)));
}

TEST(Segmentation, FewerStepsReachLessFar) {
  PointSet points(shapes::grid(101));
  std::vector<std::int32_t> seeds(points.size(), 0);
  seeds[50 * 101 + 50] = 1;
  points.set("seeds", seeds);
  const auto countAfter = [&](std::int64_t steps) {
    const std::vector<std::int32_t> labels =
        segmentsOf(points, {{"seeds", std::string("seeds")}, {"steps", steps}});
    return std::count(labels.begin(), labels.end(), 1);
  };
  const auto few = countAfter(2), more = countAfter(6), all = countAfter(200);
  EXPECT_LT(few, more);
  EXPECT_LT(more, all);
  EXPECT_EQ(all, 101 * 101);
}

TEST(Segmentation, ThePapersOwnVariantRuns) {
  const shapes::FacedPoints cube = shapes::randomCube(4000, 6);
  const std::vector<std::int32_t> labels =
      segmentsOf(PointSet(cube.positions), {{"scheme", std::string("paper")},
                                            {"diffusivity", std::string("classifier")},
                                            {"seeding", std::string("flattest")},
                                            {"steps", std::int64_t{3}}});
  EXPECT_GE(score(labels, cube.faces).facesFound, 3);
  EXPECT_GT(score(labels, cube.faces).labelled, 0.3);
}

TEST(Segmentation, DegenerateSetsEndQuietly) {
  EXPECT_THAT(segmentsOf(PointSet({{1, 2, 3}}), {}), Each(0));
  EXPECT_THAT(segmentsOf(PointSet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {}), Each(0));
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 30; ++i) line.emplace_back(static_cast<float>(i), 0.f, 0.f);
  EXPECT_EQ(segmentsOf(PointSet(line), {{"fill", true}}).size(), 30u);
  EXPECT_THAT(segmentsOf(PointSet(std::vector<Eigen::Vector3f>(50, Eigen::Vector3f(1, 1, 1))), {}), Each(0));
}

TEST(Segmentation, RefusesSeedsThatAreNone) {
  const PointSet points(shapes::grid(5));
  EXPECT_THAT(
      [&] {
        segmentsOf(points, {{"seeds", std::string("marks")}});
      },
      ThrowsMessage<InvalidInput>(HasSubstr("no attribute \"marks\"")));
}

TEST(Segmentation, DeclaresWhatTheContractPromises) {
  const std::unique_ptr<Operator> segmentation = makeSegmentation();
  const OperatorDescription& description = segmentation->description();
  EXPECT_EQ(description.id, "segmentation");
  EXPECT_EQ(description.writes, (std::vector<std::string>{"segment", "segment_signal"}));
  std::vector<std::string> ids;
  for (const Parameter& parameter : description.parameters) ids.push_back(parameter.id);
  EXPECT_THAT(ids, IsSupersetOf({"seeds", "crease_angle", "fill", "k", "diffusivity", "steps", "time_step",
                                 "threshold", "seeding", "scheme", "metric", "consensus"}));
  EXPECT_NO_THROW(checkDeclarations(description.parameters));
}

}  // namespace
}  // namespace stipple
