#include "app/jobs/operator_job.h"

#include <gmock/gmock.h>

#include <atomic>

#include "tests/app/jobs/wait_until.h"
#include "tests/support/identical.h"
#include "tests/support/test_operators.h"

namespace stipple {
namespace {

using namespace std::chrono_literals;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

PointSet fourPoints() {
  return PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
}

std::shared_ptr<const Registry> operators() {
  return std::make_shared<Registry>(testOperators());
}

Invocation invocationOf(const Registry& registry, const std::string& id,
                        std::initializer_list<const char*> assignments = {}) {
  Invocation invocation = makeInvocation(registry, id);
  for (const char* assignment : assignments) invocation.parameters.setFromAssignment(assignment);
  return invocation;
}

// A job, and the end of its thread with it.
struct Work {
  WorkerThreads threads;
  std::shared_ptr<const Registry> registry;
  std::optional<OperatorJob> job;

  explicit Work(std::shared_ptr<const Registry> given) : registry(std::move(given)) {}
  Work(const std::string& id, std::initializer_list<const char*> assignments, bool startPaused = false)
      : Work(operators()) {
    start(invocationOf(*registry, id, assignments), startPaused);
  }
  ~Work() {
    job.reset();
    EXPECT_TRUE(threads.waitForAll(30s));
  }
  void start(const Invocation& invocation, bool startPaused = false) {
    job.emplace(registry, invocation, fourPoints(), JobOptions{startPaused, threads});
  }
  bool comesTo(JobState state) const {
    return waitUntil([&] { return job->status().state == state && !job->status().inStep; });
  }
  bool hasSteps(int steps) const {
    return waitUntil([&] { return job->status().steps >= steps; });
  }
  void set(const char* assignment) {
    Parameters parameters = job->invocation().parameters;
    parameters.setFromAssignment(assignment);
    job->set(parameters);
  }
};

float heightOf(const PointSet& points) {
  return points.values<float>("height")[0];
}

TEST(OperatorJob, RunsToItsEnd) {
  Work work("stepper", {"steps=5", "amount=2"});
  ASSERT_TRUE(work.comesTo(JobState::kFinished));
  EXPECT_EQ(work.job->status().steps, 5);
  EXPECT_EQ(work.job->status().progress.fraction, 1);
  EXPECT_EQ(work.job->status().progress.message, "Stepper");
  EXPECT_THAT(work.job->takeCurve(), ElementsAre(2, 2, 2, 2, 2));
  EXPECT_THAT(work.job->takeCurve(), SizeIs(0));
  FinishedRun run = work.job->takeResult().value();
  EXPECT_FALSE(work.job->takeResult()) << "once";
  EXPECT_EQ(heightOf(run.result.points), 10);
  EXPECT_EQ(std::get<std::int64_t>(run.report.values.at(0).second), 5);
  PointSet points = fourPoints();
  run.edit.apply(points);
  EXPECT_TRUE(identical(points, run.result.points));
}

TEST(OperatorJob, PausesStepsAndGoesOn) {
  Work work("stepper", {"steps=5"}, true);
  EXPECT_EQ(work.job->status().state, JobState::kPaused);
  work.job->stepOnce();
  ASSERT_TRUE(work.hasSteps(1));
  work.job->stepOnce();
  work.job->stepOnce();
  ASSERT_TRUE(work.hasSteps(3));
  std::this_thread::sleep_for(5ms);
  EXPECT_EQ(work.job->status().steps, 3);
  EXPECT_EQ(work.job->status().state, JobState::kPaused);
  EXPECT_DOUBLE_EQ(work.job->status().progress.fraction, 0.6);
  EXPECT_FALSE(work.job->takeResult());
  work.job->resume();
  ASSERT_TRUE(work.comesTo(JobState::kFinished));
  EXPECT_EQ(heightOf(work.job->takeResult()->result.points), 5);
}

TEST(OperatorJob, PausesAfterTheStepThatGoesOn) {
  Work work("stepper", {"steps=100000", "milliseconds=2"});
  ASSERT_TRUE(work.hasSteps(1));
  work.job->pause();
  EXPECT_EQ(work.job->status().state, JobState::kPaused);
  ASSERT_TRUE(work.comesTo(JobState::kPaused));
  const int steps = work.job->status().steps;
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(work.job->status().steps, steps);
}

TEST(OperatorJob, StoppingKeepsWhatWasDone) {
  Work work("stepper", {"steps=100000", "milliseconds=1"});
  ASSERT_TRUE(work.hasSteps(3));
  work.job->stop();
  ASSERT_TRUE(work.comesTo(JobState::kFinished));
  const auto steps = static_cast<float>(work.job->status().steps);
  EXPECT_GE(steps, 3);
  work.set("amount=5");
  EXPECT_EQ(work.job->status().state, JobState::kFinished) << "for good";
  EXPECT_EQ(heightOf(work.job->takeResult()->result.points), steps);
  EXPECT_TRUE(work.threads.waitForAll(30s));
}

TEST(OperatorJob, StoppedBeforeItsFirstStepItHasChangedNothing) {
  Work work("stepper", {}, true);
  work.job->stop();
  ASSERT_TRUE(work.comesTo(JobState::kFinished));
  EXPECT_TRUE(work.job->takeResult()->edit.empty());
}

TEST(OperatorJob, ParametersActAtTheNextStep) {
  Work work("stepper", {"steps=3"}, true);
  work.job->stepOnce();
  ASSERT_TRUE(work.hasSteps(1));
  work.set("amount=10");
  EXPECT_EQ(std::get<double>(work.job->invocation().parameters.value("amount")), 10);
  work.job->resume();
  ASSERT_TRUE(work.comesTo(JobState::kFinished));
  EXPECT_THAT(work.job->takeCurve(), ElementsAre(1, 10, 10));
  EXPECT_EQ(heightOf(work.job->takeResult()->result.points), 21);
}

// Sets every height to "value".
Registry oneShot() {
  Registry registry;
  registry.add(
      makeOneShot({.id = "fill", .title = "Fill", .parameters = {{.id = "value", .defaultValue = 1.0}}},
                  [](const OneShotInput& input, Progress& progress, Report&) {
                    progress.report(0.5, "filling");
                    RunResult result{.points = input.points};
                    const auto value = static_cast<float>(input.parameters.number("value"));
                    result.points.set("height", std::vector<float>(input.points.size(), value));
                    return result;
                  }));
  return registry;
}

TEST(OperatorJob, AFinishedOneShotRunsAgainWhenSet) {
  Work work(std::make_shared<Registry>(oneShot()));
  work.start(invocationOf(*work.registry, "fill"));
  ASSERT_TRUE(work.comesTo(JobState::kFinished));
  EXPECT_EQ(heightOf(work.job->takeResult()->result.points), 1);
  work.set("value=3");
  ASSERT_TRUE(work.comesTo(JobState::kFinished));
  EXPECT_EQ(heightOf(work.job->takeResult()->result.points), 3);
  work.job->pause();
  work.set("value=4");
  ASSERT_TRUE(work.comesTo(JobState::kFinished));
  EXPECT_EQ(heightOf(work.job->takeResult()->result.points), 4);
  EXPECT_EQ(work.job->status().steps, 3);
}

TEST(OperatorJob, ShowsIntermediateStates) {
  Work work("stepper", {"steps=4"}, true);
  EXPECT_FALSE(work.job->takePreview());
  work.job->stepOnce();
  ASSERT_TRUE(work.hasSteps(1));
  EXPECT_EQ(heightOf(work.job->takePreview().value()), 1);
  EXPECT_FALSE(work.job->takePreview());
  work.job->stepOnce();
  work.job->stepOnce();
  ASSERT_TRUE(work.hasSteps(3));
  EXPECT_EQ(heightOf(work.job->takePreview().value()), 3) << "the latest";
}

// Counts how often its result is asked for; publishes nothing.
class CountingRun final : public Run {
 public:
  CountingRun(PointSet points, std::shared_ptr<std::atomic<int>> asked)
      : points_(std::move(points)), asked_(std::move(asked)) {}
  StepState step(Progress&) override {
    points_.editPositions()[0].x() += 1;
    return {.finished = false, .fraction = 0.5};
  }
  void set(const Parameters&) override {}
  RunResult result() const override { return ++*asked_, RunResult{.points = points_}; }

 private:
  PointSet points_;
  std::shared_ptr<std::atomic<int>> asked_;
};

class Counting final : public Operator {
 public:
  explicit Counting(std::shared_ptr<std::atomic<int>> asked) : asked_(std::move(asked)) {}
  const OperatorDescription& description() const override { return description_; }
  std::unique_ptr<Run> start(PointSet snapshot, Region, const Parameters&) const override {
    return std::make_unique<CountingRun>(std::move(snapshot), asked_);
  }

 private:
  OperatorDescription description_{.id = "counting", .title = "Counting"};
  std::shared_ptr<std::atomic<int>> asked_;
};

TEST(OperatorJob, MakesNoStateThatNobodyTakes) {
  const auto asked = std::make_shared<std::atomic<int>>(0);
  Registry registry;
  registry.add(std::make_unique<Counting>(asked));
  Work work(std::make_shared<Registry>(std::move(registry)));
  work.start(invocationOf(*work.registry, "counting"), true);
  for (int step = 1; step <= 5; ++step) {
    work.job->stepOnce();
    ASSERT_TRUE(work.hasSteps(step));
  }
  EXPECT_EQ(*asked, 1);
  EXPECT_EQ(work.job->takePreview()->positions()[0].x(), 1);
  work.job->stepOnce();
  ASSERT_TRUE(work.hasSteps(6));
  EXPECT_EQ(work.job->takePreview()->positions()[0].x(), 6);
  EXPECT_EQ(*asked, 2);
}

TEST(OperatorJob, CancelIsSeenAtOnceThoughTheStepGoesOn) {
  const auto goOn = std::make_shared<std::atomic<bool>>(false);
  const auto isInside = std::make_shared<std::atomic<bool>>(false);
  Registry registry;
  registry.add(
      makeOneShot({.id = "deaf", .title = "Deaf"}, [=](const OneShotInput& input, Progress&, Report&) {
        *isInside = true;
        waitUntil([&] { return goOn->load(); });
        return RunResult{.points = input.points};
      }));
  Work work(std::make_shared<Registry>(std::move(registry)));
  work.start(invocationOf(*work.registry, "deaf"));
  ASSERT_TRUE(waitUntil([&] { return isInside->load(); }));
  const auto begin = std::chrono::steady_clock::now();
  work.job->cancel();
  EXPECT_EQ(work.job->status().state, JobState::kCancelled);
  work.job.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 250ms);
  EXPECT_EQ(work.threads.running(), 1) << "abandoned";
  *goOn = true;
}

TEST(OperatorJob, CancelEndsAStepThatListens) {
  Work work("stepper", {"milliseconds=100000"});
  ASSERT_TRUE(waitUntil([&] { return work.job->status().inStep; }));
  work.job->cancel();
  EXPECT_TRUE(work.threads.waitForAll(30s));
  EXPECT_EQ(work.job->status().state, JobState::kCancelled);
  EXPECT_FALSE(work.job->takeResult());
}

TEST(OperatorJob, FailuresAreASentence) {
  for (const auto& [how, sentence] : {std::pair("how=invalid_input", "misbehave: the points are too blue"),
                                      std::pair("how=number", "misbehave: it threw something"),
                                      std::pair("how=lose_points", "misbehave: it returned 3 of 4 points")}) {
    Work work("misbehave", {how});
    ASSERT_TRUE(work.comesTo(JobState::kFailed));
    EXPECT_THAT(work.job->status().failure, HasSubstr(sentence));
    EXPECT_FALSE(work.job->takeResult());
  }
  Work work("mark_mask", {});
  ASSERT_TRUE(work.comesTo(JobState::kFailed));
  EXPECT_THAT(work.job->status().failure, HasSubstr("needs a region"));
}

TEST(OperatorJob, ItsResultMergesWithWhatWasPaintedMeanwhile) {
  Work work("stepper", {"steps=2"}, true);
  PointSet now = work.job->snapshot();
  now.set("height", std::vector<float>{0, 9, 0, 0});
  work.job->resume();
  ASSERT_TRUE(work.comesTo(JobState::kFinished));
  MergedRun merged = mergeRun(*work.job->takeResult(), now);
  merged.edit.apply(now);
  EXPECT_THAT(now.values<float>("height"), ElementsAre(2, 9, 2, 2));
  EXPECT_EQ(merged.keptByUser, 1u);
}

TEST(OperatorJob, ManyAtOnceWithAnImpatientOwner) {
  WorkerThreads threads;
  const auto registry = operators();
  const Invocation invocation = invocationOf(*registry, "stepper", {"steps=100000"});
  for (int i = 0; i < 30; ++i) {
    OperatorJob job(registry, invocation, fourPoints(), {.startPaused = i % 3 == 0, .threads = threads});
    job.stepOnce();
    job.set(invocation.parameters);
    if (const auto preview = job.takePreview()) {
      EXPECT_THAT(preview->values<float>("height"), Each(heightOf(*preview)));
    }
    job.takeCurve();
    if (i % 2 == 0) job.stop();
    OperatorJob moved = std::move(job);
    moved.resume();
    moved.status();
  }
  EXPECT_TRUE(threads.waitForAll(30s));
}

}  // namespace
}  // namespace stipple
