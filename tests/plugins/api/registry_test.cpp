#include "plugins/api/registry.h"

#include <gmock/gmock.h>

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::unique_ptr<Operator> named(const std::string& id) {
  return makeOneShot({.id = id, .title = id}, [](const OneShotInput& input, Progress&, Report&) {
    return RunResult{.points = input.points};
  });
}

TEST(Registry, FindsByIdAndListsSorted) {
  Registry registry;
  registry.add(named("segmentation"));
  registry.add(named("classifier"));
  ASSERT_EQ(registry.operators().size(), 2u);
  EXPECT_EQ(registry.operators()[0]->description().id, "classifier");
  EXPECT_EQ(registry.find("segmentation")->description().id, "segmentation");
  EXPECT_EQ(registry.find("fairing"), nullptr);
}

TEST(Registry, RefusesWhatIsTakenOrIllFormed) {
  Registry registry;
  registry.add(named("fairing"));
  EXPECT_THAT([&] { registry.add(named("fairing")); }, ThrowsMessage<InvalidInput>(HasSubstr("'fairing'")));
  EXPECT_THROW(registry.add(named("Fairing")), InvalidInput);
  EXPECT_THROW(registry.add(named("")), InvalidInput);
  auto broken = makeOneShot({.id = "broken", .parameters = {{.id = "k", .defaultValue = "x"}}}, nullptr);
  EXPECT_THAT([&] { registry.add(std::move(broken)); },
              ThrowsMessage<InvalidInput>(HasSubstr("operator 'broken'")));
  EXPECT_EQ(registry.operators().size(), 1u);
}

TEST(Registry, MergesAllOrNothing) {
  Registry registry, clashing, other;
  registry.add(named("b"));
  clashing.add(named("a"));
  clashing.add(named("b"));
  EXPECT_THROW(registry.merge(std::move(clashing)), InvalidInput);
  EXPECT_EQ(registry.operators().size(), 1u);
  other.add(named("c"));
  registry.merge(std::move(other));
  EXPECT_EQ(registry.operators().size(), 2u);
}

}  // namespace
}  // namespace stipple
