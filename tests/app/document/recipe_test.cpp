#include "app/document/recipe.h"

#include <gmock/gmock.h>

#include "app/document/border.h"
#include "tests/support/test_operators.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kExample = R"({"stipple_recipe": 1, "steps": [
  {"operator": "stepper", "parameters": {"steps": 3, "amount": 2, "tilt": 45.5}},
  {"stroke": {"tool": "paint", "attribute": "mask", "value": 5, "radius": 0.5, "strength": 1, "dabs": [[2, 0, 0, 1]]}},
  {"operator": "mark_mask", "region": "mask"}]})";

PointSet fourPoints() {
  return PointSet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
}

TEST(Recipe, PlaysItsStepsInOrder) {
  const Registry registry = testOperators();
  Progress progress;
  const PointSet played = play(parseRecipe(kExample, registry), registry, fourPoints(), progress).points;
  EXPECT_EQ(played.values<float>("height")[0], 6);
  EXPECT_THAT(played.values<std::int32_t>("mask"), ElementsAre(0, 0, 5, 0));
  EXPECT_THAT(played.values<std::int32_t>("inside"), ElementsAre(0, 0, 1, 0));
}

TEST(Recipe, IsTheSameAfterWritingAndReading) {
  const Registry registry = testOperators();
  const Recipe recipe = parseRecipe(kExample, registry);
  const std::string text = formatRecipe(recipe);
  const Recipe again = parseRecipe(text, registry);
  ASSERT_EQ(again.steps.size(), 3u);
  EXPECT_EQ(std::get<Invocation>(again.steps[0]).parameters.integer("steps"), 3);
  EXPECT_EQ(std::get<double>(std::get<Invocation>(again.steps[0]).parameters.value("tilt")), 45.5);
  EXPECT_EQ(std::get<Stroke>(again.steps[1]).dabs.at(0).position.x(), 2);
  EXPECT_EQ(std::get<Invocation>(again.steps[2]).region, "mask");
  EXPECT_EQ(formatRecipe(again), text);
}

std::string withSteps(const std::string& steps) {
  return R"({"stipple_recipe":1,"steps":[)" + steps + "]}";
}

std::string withStroke(const std::string& fields) {
  return withSteps(R"({"stroke":{)" + fields + "}}");
}

TEST(Recipe, RefusesWhatIsNotARecipe) {
  const Registry registry = testOperators();
  const auto parsing = [&](const std::string& text) {
    return [&registry, text] { parseRecipe(text, registry); };
  };
  const std::string good = R"("tool":"paint","attribute":"a","value":1,"radius":1,"dabs":[[0,0,0,1]])";
  EXPECT_NO_THROW(parsing(withStroke(good))());
  const std::vector<std::pair<std::string, const char*>> cases = {
      {"", "not JSON"},
      {"[1]", "the recipe is not an object"},
      {R"({"steps":[]})", "has no 'stipple_recipe'"},
      {R"({"stipple_recipe":2,"steps":[]})", "not of version 1"},
      {R"({"stipple_recipe":1})", "has no 'steps'"},
      {R"({"stipple_recipe":1,"steps":{}})", "steps is not a list"},
      {R"({"stipple_recipe":1,"steps":[],"author":"me"})", "unknown key 'author'"},
      {withSteps("3"), "step 1 is not an object"},
      {withSteps("{}"), "step 1 has no 'operator' and no 'stroke'"},
      {withSteps(R"({"comment":"x"})"), "step 1 has the unknown key 'comment'"},
      {withSteps(R"({"operator":"stepper","seed":1})"), "step 1 has the unknown key 'seed'"},
      {withSteps(R"({"operator":"stepper","stroke":{}})"), "step 1 has the unknown key 'operator'"},
      {withSteps(R"({"operator":7})"), "operator is not a text"},
      {withSteps(R"({"operator":"stepper","parameters":{"speed":1}})"), "unknown key 'speed'"},
      {withSteps(R"({"operator":"stepper","parameters":{"steps":[1]}})"), "not a bool, number or text"},
      {withStroke(good + R"(,"color":1)"), "step 1: stroke has the unknown key 'color'"},
      {withStroke(R"("tool":"smear","attribute":"a","value":1,"radius":1,"dabs":[])"),
       "'smear', expected paint, erase or smooth"},
      {withStroke(R"("tool":"paint","attribute":"a","radius":1,"dabs":[])"), "has no 'value'"},
      {withStroke(R"("tool":"paint","attribute":"a","value":1,"radius":0,"dabs":[])"),
       "radius is 0, expected > 0"},
      {withStroke(R"("tool":"paint","attribute":"a","value":1,"radius":1,"strength":2,"dabs":[])"),
       "strength is 2"},
      {withStroke(R"("tool":"paint","attribute":"a","value":1,"radius":1,"dabs":[[0,0,0]])"),
       "dabs[0] is not [x,y,z,pressure]"},
      {withStroke(R"("tool":"paint","attribute":"a","value":1,"radius":1,"dabs":[[0,0,0,2]])"), "pressure 2"},
      {withStroke(R"("tool":"paint","attribute":"a","value":1,"radius":1,"dabs":[[0,0,0,1,0]])"), "size 0"},
  };
  for (const auto& [text, message] : cases) {
    EXPECT_THAT(parsing(text), ThrowsMessage<InvalidInput>(HasSubstr(message))) << text;
  }
}

TEST(Recipe, StrokesMaySmoothAndStayWithinAnAttribute) {
  const Registry registry = testOperators();
  const std::string text =
      withStroke(R"("tool":"smooth","attribute":"height","radius":1.5,"within":"mask","dabs":[[1,0,0,1]])");
  const Recipe recipe = parseRecipe(text, registry);
  EXPECT_EQ(formatRecipe(parseRecipe(formatRecipe(recipe), registry)), formatRecipe(recipe));
  PointSet points = fourPoints();
  points.set("height", std::vector<float>{0, 4, 0, 0});
  Progress progress;
  EXPECT_THAT([&] { play(recipe, registry, points, progress); },
              ThrowsMessage<UsageError>(HasSubstr("step 1: there is no attribute 'mask' to paint within")));
  points.set("mask", std::vector<std::int32_t>{0, 1, 0, 1});
  const PointSet played = play(recipe, registry, points, progress).points;
  EXPECT_THAT(played.values<float>("height"), ElementsAre(0, 0, 0, 0));
}

TEST(Recipe, DabsMayHaveASize) {
  const Registry registry = testOperators();
  const std::string text = withStroke(
      R"("tool":"paint","attribute":"a","value":1,"radius":1,"dabs":[[0,0,0,1],[1,0,0,0.5,0.25]])");
  const Recipe recipe = parseRecipe(text, registry);
  const Stroke& stroke = std::get<Stroke>(recipe.steps.at(0));
  EXPECT_EQ(stroke.dabs.at(0).size, 1);
  EXPECT_EQ(stroke.dabs.at(1).size, 0.25);
  const Recipe again = parseRecipe(formatRecipe(recipe), registry);
  EXPECT_EQ(std::get<Stroke>(again.steps.at(0)).dabs.at(1).size, 0.25);
}

TEST(Recipe, UnknownOperatorsAndValuesOutOfRangeAreUsageErrors) {
  const Registry registry = testOperators();
  const auto parsing = [&](const std::string& text) {
    return [&registry, text] { parseRecipe(text, registry); };
  };
  EXPECT_THAT(parsing(withSteps(R"({"operator":"polish"})")),
              ThrowsMessage<UsageError>(HasSubstr("step 1: there is no operator 'polish'")));
  EXPECT_THAT(parsing(withSteps(R"({"operator":"stepper","parameters":{"steps":0}})")),
              ThrowsMessage<UsageError>(HasSubstr("step 1: parameter 'steps' is '0'")));
}

TEST(Recipe, FailuresNameTheStep) {
  const Registry registry = testOperators();
  Progress progress;
  const auto playing = [&](const std::string& text) {
    return
        [&registry, &progress, text] { play(parseRecipe(text, registry), registry, fourPoints(), progress); };
  };
  EXPECT_THAT(playing(withSteps(R"({"operator":"stepper"},{"operator":"misbehave"})")),
              ThrowsMessage<OperatorFailure>(HasSubstr("step 2: misbehave: ")));
  EXPECT_THAT(playing(withSteps(R"({"operator":"mark_mask","region":"hole"})")),
              ThrowsMessage<UsageError>(HasSubstr("step 1: the region attribute 'hole'")));
}

}  // namespace
}  // namespace stipple
