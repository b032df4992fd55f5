#include "app/document/invocation.h"

#include <gmock/gmock.h>

#include "tests/support/test_operators.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

PointSet fourPoints() {
  PointSet points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  points.set("mask", std::vector<float>{0, 2, 0, -1});
  return points;
}

TEST(Invocation, StepsUntilFinished) {
  const Registry registry = testOperators();
  Invocation invocation = makeInvocation(registry, "stepper");
  invocation.parameters.setFromAssignment("steps=7");
  Progress progress;
  const InvocationResult done = invoke(registry, invocation, fourPoints(), progress);
  EXPECT_EQ(done.steps, 7);
  EXPECT_EQ(done.result.points.values<float>("height")[3], 7);
  EXPECT_EQ(std::get<std::int64_t>(done.report.values.at(0).second), 7);
}

TEST(Invocation, TheRegionIsWhereTheAttributeIsNotZero) {
  const Registry registry = testOperators();
  Invocation invocation = makeInvocation(registry, "mark_mask");
  invocation.region = "mask";
  Progress progress;
  const auto done = invoke(registry, invocation, fourPoints(), progress);
  EXPECT_THAT(done.result.points.values<std::int32_t>("inside"), ElementsAre(0, 1, 0, 1));
}

TEST(Invocation, WithoutARegionLimitsMeanEverywhere) {
  const Registry registry = testOperators();
  Progress progress;
  const auto done = invoke(registry, makeInvocation(registry, "mark_limits"), fourPoints(), progress);
  EXPECT_THAT(done.result.points.values<std::int32_t>("inside"), ElementsAre(1, 1, 1, 1));
}

TEST(Invocation, WhatTheUserAskedForIsCheckedBeforeTheStart) {
  const Registry registry = testOperators();
  Progress progress;
  const auto invoking = [&](Invocation invocation) {
    return [&registry, &progress, invocation] { invoke(registry, invocation, fourPoints(), progress); };
  };
  EXPECT_THAT([&] { makeInvocation(registry, "polish"); },
              ThrowsMessage<UsageError>(HasSubstr("'polish', expected one of")));
  EXPECT_THAT(invoking(makeInvocation(registry, "mark_mask")),
              ThrowsMessage<UsageError>(HasSubstr("needs a region")));
  Invocation noSuchRegion = makeInvocation(registry, "mark_mask");
  noSuchRegion.region = "hole";
  EXPECT_THAT(invoking(noSuchRegion), ThrowsMessage<UsageError>(HasSubstr("'hole' is not in the points")));
  Invocation noRegionTaken = makeInvocation(registry, "stepper");
  noRegionTaken.region = "mask";
  EXPECT_THAT(invoking(noRegionTaken), ThrowsMessage<UsageError>(HasSubstr("takes no region")));
  Invocation noSuchAttribute = makeInvocation(registry, "stepper");
  noSuchAttribute.parameters.setFromAssignment("like=heat");
  EXPECT_THAT(invoking(noSuchAttribute),
              ThrowsMessage<UsageError>(HasSubstr("'heat', which is not in the points")));
}

TEST(Invocation, RemovedRowsAreDeclared) {
  const Registry registry = testOperators();
  Progress progress;
  const auto done = invoke(registry, makeInvocation(registry, "thin_out"), fourPoints(), progress);
  EXPECT_THAT(done.result.removedRows, ElementsAre(1, 3));
  EXPECT_EQ(done.result.points.size(), 2u);
}

}  // namespace
}  // namespace stipple
