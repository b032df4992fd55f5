#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/io/point_io.h"
#include "tests/plugins/segmentation/segment_points.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

PointSet readScan(const std::string& path) {
  Progress progress;
  return readPoints(testData(path), progress).points;
}

// Labels 1, 2, ... at points each farthest from those before: tips of ears, feet, tail.
std::vector<std::int32_t> seedsAtTips(const PointSet& points, int count) {
  std::vector<std::int32_t> seeds(points.size(), 0);
  std::vector<float> distance(points.size(), std::numeric_limits<float>::max());
  std::size_t next = 0;
  for (int label = 1; label <= count; ++label) {
    seeds[next] = label;
    const Eigen::Vector3f seed = points.positions()[next];
    for (std::size_t i = 0; i < distance.size(); ++i) {
      distance[i] = std::min(distance[i], (points.positions()[i] - seed).norm());
      if (distance[i] > distance[next]) next = i;
    }
  }
  return seeds;
}

struct Agreement {
  double labels = 0, signalRms = 0;
};

Agreement compareWithMesh(const std::string& path) {
  PointSet points = readScan(path);
  points.set("seeds", seedsAtTips(points, 6));
  const PointSet onPoints = segmentPoints(points, {{"seeds", std::string("seeds")}, {"fill", true}});
  const PointSet onMesh = segmentPoints(
      points, {{"seeds", std::string("seeds")}, {"fill", true}, {"scheme", std::string("mesh")}});
  const auto a = onPoints.values<std::int32_t>("segment"), b = onMesh.values<std::int32_t>("segment");
  const auto u = onPoints.values<float>("segment_signal"), v = onMesh.values<float>("segment_signal");
  Agreement agreement;
  for (std::size_t i = 0; i < a.size(); ++i) {
    agreement.labels += a[i] == b[i] ? 1 : 0;
    agreement.signalRms += (u[i] - v[i]) * (u[i] - v[i]);
  }
  agreement.labels /= static_cast<double>(a.size());
  agreement.signalRms = std::sqrt(agreement.signalRms / static_cast<double>(a.size()));
  return agreement;
}

class OnScansWithFaces : public testing::TestWithParam<const char*> {};
std::string nameOfScan(const testing::TestParamInfo<const char*>& info) {
  constexpr const char* kNames[] = {"Bunny", "Igea", "Armadillo", "RockerArm"};
  return kNames[info.index];
}
INSTANTIATE_TEST_SUITE_P(Segmentation, OnScansWithFaces,
                         testing::Values("smooth/bun_zipper_ascii.ply", "smooth/igea_134k.ply",
                                         "smooth/armadillo_43k.obj", "cad/rocker-arm.obj"),
                         nameOfScan);

TEST_P(OnScansWithFaces, PointsAndMeshAgree) {
  STIPPLE_NEEDS_TEST_DATA();
  const Agreement agreement = compareWithMesh(GetParam());
  std::printf("%s: %.4f of the labels agree, signals differ by %.4f RMS\n", GetParam(), agreement.labels,
              agreement.signalRms);
  EXPECT_GE(agreement.labels, 0.99);
  EXPECT_LE(agreement.signalRms, 0.02);
}

TEST(Segmentation, FandiskFallsIntoItsTwelveFaces) {
  STIPPLE_NEEDS_TEST_DATA();
  const PointSet mesh = readScan("cad/fandisk.off");
  const shapes::FacedPoints samples = shapes::sampleFaces(mesh, 40 * std::numbers::pi / 180, 21000, 1);
  const Score found = score(segmentsOf(PointSet(samples.positions), {}), samples.faces);
  const Score filled = score(segmentsOf(PointSet(samples.positions), {{"fill", true}}), samples.faces);
  std::printf("%d segments, %d faces, purity %.4f; filled: right %.4f\n", found.segments, found.facesFound,
              found.purity, filled.right);
  EXPECT_EQ(found.facesFound, 12);
  EXPECT_GE(found.purity, 0.99);
  EXPECT_GE(filled.right, 0.97);
  EXPECT_EQ(filled.labelled, 1);
}

}  // namespace
}  // namespace stipple
