#include "plugins/api/operator.h"

#include <gtest/gtest.h>

namespace stipple {
namespace {

// Writes the value of its parameter into `height`.
std::unique_ptr<Operator> heightWriter() {
  return makeOneShot({.id = "height",
                      .title = "Height",
                      .parameters = {{.id = "value", .defaultValue = 1}},
                      .writes = {"height"}},
                     [](const OneShotInput& input, Progress& progress, Report& report) {
                       progress.throwIfCancelled();
                       const auto value = static_cast<float>(input.parameters.number("value"));
                       RunResult result{.points = input.points};
                       result.points.set("height", std::vector<float>(input.points.size(), value));
                       report.values.emplace_back("value", input.parameters.number("value"));
                       return result;
                     });
}

TEST(OneShot, HasTheSnapshotAsResultUntilItsStep) {
  const auto op = heightWriter();
  const PointSet points({{0, 0, 0}, {1, 0, 0}});
  const auto run = op->start(points, {}, Parameters(op->description().parameters));
  EXPECT_FALSE(run->result().points.has("height"));
  Progress progress;
  EXPECT_TRUE(run->step(progress).finished);
  EXPECT_EQ(run->result().points.values<float>("height")[1], 1);
  EXPECT_EQ(run->report().values.at(0).first, "value");
  EXPECT_FALSE(points.has("height"));
}

TEST(OneShot, SetActsAtTheNextStep) {
  const auto op = heightWriter();
  Parameters parameters(op->description().parameters);
  const auto run = op->start(PointSet({{0, 0, 0}}), {}, parameters);
  Progress progress;
  run->step(progress);
  parameters.setFromAssignment("value=5");
  run->set(parameters);
  EXPECT_EQ(run->result().points.values<float>("height")[0], 1);
  run->step(progress);
  EXPECT_EQ(run->result().points.values<float>("height")[0], 5);
}

TEST(OneShot, KeepsItsResultWhenCancelled) {
  struct Stopped final : Progress {
    bool cancelled() const override { return true; }
  } stopped;
  const auto op = heightWriter();
  const auto run = op->start(PointSet({{0, 0, 0}}), {}, Parameters(op->description().parameters));
  EXPECT_THROW(run->step(stopped), Cancelled);
  EXPECT_FALSE(run->result().points.has("height"));
}

}  // namespace
}  // namespace stipple
