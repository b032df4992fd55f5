#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/mesh_edges.h"
#include "plugins/triangulation/triangulation.h"
#include "tests/support/identical.h"
#include "tests/support/shapes.h"
#include "tests/support/undoable.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using Settings = std::vector<std::pair<std::string, ParameterValue>>;

std::unique_ptr<Run> start(const PointSet& points, const Settings& settings = {}) {
  Parameters parameters(makeTriangulation()->description().parameters);
  for (const auto& [id, value] : settings) parameters.set(id, value);
  return makeTriangulation()->start(points, {}, parameters);
}

std::int64_t reported(const Run& run, const std::string& name) {
  const Report report = run.report();
  for (const auto& [key, value] : report.values) {
    if (key == name) return std::get<std::int64_t>(value);
  }
  ADD_FAILURE() << "there is no " << name << " in the report";
  return -1;
}

// A sphere with every hundredth point twice.
PointSet sphere() {
  std::vector<Eigen::Vector3f> positions = shapes::randomSphere(5000);
  for (std::size_t i = 0; i < 5000; i += 100) positions.push_back(positions[i]);
  PointSet points(positions);
  points.set("height", std::vector<float>(points.size(), 3.0f));
  return points;
}

TEST(TriangulationPlugin, WritesTrianglesOfTheRowsAndReportsWhatTheyAre) {
  const PointSet points = sphere();
  const auto run = start(points);
  Progress progress;
  EXPECT_TRUE(run->step(progress).finished);
  const PointSet result = run->result().points;
  const MeshReport mesh = describeMesh(result.triangles(), result.size());
  EXPECT_EQ(mesh.eulerNumber, 2);
  EXPECT_EQ(mesh.vertices, 5000u) << "copies share the corner of the first";
  EXPECT_EQ(reported(*run, "triangles"), static_cast<std::int64_t>(result.triangles().size()));
  EXPECT_EQ(reported(*run, "euler_number"), 2);
  EXPECT_EQ(reported(*run, "boundary_edges"), 0);
  EXPECT_EQ(reported(*run, "non_manifold_edges"), 0);
  EXPECT_EQ(reported(*run, "unused_points"), 0);
}

TEST(TriangulationPlugin, ChangesNothingElseAndIsUndone) {
  const PointSet points = sphere();
  const auto run = start(points);
  Progress progress;
  run->step(progress);
  const Edit edit = difference(points, run->result().points);
  EXPECT_TRUE(edit.changesTriangles());
  EXPECT_TRUE(edit.touched().empty());
  expectUndoable(points, run->result());
}

TEST(TriangulationPlugin, SaysWhereThereIsNoSurface) {
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 20; ++i) line.emplace_back(static_cast<float>(i), 0, 0);
  const auto run = start(PointSet(line));
  EXPECT_THAT(
      [&] {
        Progress progress;
        run->step(progress);
      },
      ThrowsMessage<Error>(HasSubstr("no three points agree on a triangle")));
}

TEST(TriangulationPlugin, StopsWhenCancelled) {
  class Stop final : public Progress {
    bool cancelled() const override { return true; }
  } stop;
  const PointSet points = sphere();
  const auto run = start(points);
  EXPECT_THROW(run->step(stop), Cancelled);
  EXPECT_TRUE(identical(run->result().points, points));
}

TEST(TriangulationPlugin, LeavesHolesWhereAskedTo) {
  std::vector<Eigen::Vector3f> positions = shapes::randomSphere(20'000);
  std::erase_if(positions, [](const Eigen::Vector3f& p) { return p.z() > 0.99f; });
  const auto loopsAfter = [&](std::int64_t fill) {
    const auto run = start(PointSet(positions), {{"fill_holes", fill}});
    Progress progress;
    run->step(progress);
    return reported(*run, "boundary_loops");
  };
  EXPECT_GE(loopsAfter(0), 1);
  EXPECT_EQ(loopsAfter(500), 0);
}

}  // namespace
}  // namespace stipple
