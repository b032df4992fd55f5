#include "app/document/border.h"

#include <gmock/gmock.h>

#include "tests/support/test_operators.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

PointSet twoPoints() {
  return PointSet({{0, 0, 0}, {1, 0, 0}});
}

class StopAfter final : public Progress {
 public:
  explicit StopAfter(int published) : left_(published) {}
  void publish(const PointSet&) override { --left_; }
  bool cancelled() const override { return left_ <= 0; }

 private:
  int left_;
};

struct Started {
  Registry registry = testOperators();
  const Operator* op;
  Parameters parameters;

  explicit Started(const char* id) : op(registry.find(id)), parameters(op->description().parameters) {}
  std::unique_ptr<Run> run() const { return startGuarded(*op, twoPoints(), {}, parameters); }
};

float heightOf(const Run& run) {
  return run.result().points.values<float>("height")[0];
}

TEST(Border, ARunMayPauseBetweenStepsAndShowsTheLastCompleteOne) {
  const Started stepper("stepper");
  const auto run = stepper.run();
  Progress progress;
  EXPECT_EQ(heightOf(*run), 0);
  const StepState first = run->step(progress);
  EXPECT_FALSE(first.finished);
  EXPECT_DOUBLE_EQ(first.fraction, 0.25);
  EXPECT_EQ(first.curve, 1.0);
  EXPECT_EQ(heightOf(*run), 1);
  EXPECT_EQ(heightOf(*run), 1);
  run->step(progress);
  run->step(progress);
  EXPECT_TRUE(run->step(progress).finished);
  EXPECT_EQ(heightOf(*run), 4);
}

TEST(Border, SetActsAtTheNextStep) {
  Started stepper("stepper");
  const auto run = stepper.run();
  Progress progress;
  run->step(progress);
  stepper.parameters.setFromAssignment("amount=10");
  stepper.parameters.setFromAssignment("steps=2");
  run->set(stepper.parameters);
  EXPECT_EQ(heightOf(*run), 1);
  EXPECT_TRUE(run->step(progress).finished);
  EXPECT_EQ(heightOf(*run), 11);
}

TEST(Border, CancelKeepsTheLastCompleteStepAndTheRunGoesOn) {
  Started stepper("stepper");
  stepper.parameters.setFromAssignment("milliseconds=1");
  const auto run = stepper.run();
  StopAfter stop(2);
  run->step(stop);
  run->step(stop);
  EXPECT_THROW(run->step(stop), Cancelled);
  EXPECT_EQ(heightOf(*run), 2);
  Progress progress;
  run->step(progress);
  EXPECT_EQ(heightOf(*run), 3);
}

TEST(Border, EveryExceptionOfAPluginBecomesAFailureThatNamesIt) {
  Started plugin("misbehave");
  Progress progress;
  const std::vector<std::pair<const char*, const char*>> cases = {
      {"standard", "misbehave: first line"},
      {"invalid_input", "misbehave: the points are too blue"},
      {"number", "misbehave: it threw something"},
      {"memory", "misbehave: out of memory"}};
  for (const auto& [how, message] : cases) {
    plugin.parameters.setFromText("how", how);
    const auto run = plugin.run();
    EXPECT_THAT([&] { run->step(progress); }, ThrowsMessage<OperatorFailure>(HasSubstr(message)));
  }
}

TEST(Border, ResultsThatLosePointsAreRefused) {
  Started plugin("misbehave");
  plugin.parameters.setFromText("how", "lose_points");
  const auto run = plugin.run();
  Progress progress;
  run->step(progress);
  EXPECT_THAT([&] { run->result(); }, ThrowsMessage<OperatorFailure>(HasSubstr("returned 1 of 2 points")));
}

}  // namespace
}  // namespace stipple
