#include "tests/app/cli/cli_fixture.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(Cli, PlayDoesTheSteps) {
  const std::string recipe = write("recipe.json", R"({"stipple_recipe":1,"steps":[
    {"stroke":{"tool":"paint","attribute":"hole","value":1,"radius":1.5,"strength":1,"dabs":[[0.1,0,0,1]]}},
    {"operator":"mark_mask","region":"hole"},
    {"operator":"stepper","parameters":{"amount":0}}]})");
  const ProgramRun done = run({"play", recipe, writeExample(), "-o", path("out.ply")});
  EXPECT_EQ(done.exitCode, 0);
  EXPECT_EQ(done.out, "");
  EXPECT_THAT(done.err, HasSubstr("step 3: nothing was added"));
  const PointSet points = read("out.ply");
  EXPECT_THAT(points.values<std::int32_t>("hole"), ElementsAre(1, 1, 0, 0, 1));
  EXPECT_THAT(points.values<std::int32_t>("inside"), ElementsAre(1, 1, 0, 0, 1));
}

TEST_F(Cli, PlaySaysWhatIsWrongWithARecipe) {
  const std::string example = writeExample(), out = path("out.ply");
  const auto failing = [&](int exitCode, const std::string& recipe) {
    return failWith(exitCode, {"play", write("recipe.json", recipe), example, "-o", out});
  };
  const auto withStep = [](const std::string& step) {
    return R"({"stipple_recipe":1,"steps":[)" + step + "]}";
  };
  EXPECT_THAT(failWith(3, {"play", path("absent.json"), example, "-o", out}), HasSubstr("absent.json"));
  EXPECT_THAT(failWith(3, {"play", folder_.string(), example, "-o", out}), HasSubstr("directory"));
  EXPECT_THAT(failing(3, "{"), HasSubstr("recipe.json: it is not JSON"));
  EXPECT_THAT(failing(3, R"({"stipple_recipe":1,"steps":[],"name":"x"})"), HasSubstr("unknown key 'name'"));
  EXPECT_THAT(failing(3, withStep(R"({"operator":"stepper","speed":1})")), HasSubstr("unknown key 'speed'"));
  EXPECT_THAT(failing(2, withStep(R"({"operator":"polish"})")),
              HasSubstr("recipe.json: step 1: there is no operator"));
  EXPECT_THAT(failing(2, withStep(R"({"operator":"stepper","parameters":{"steps":0}})")),
              HasSubstr("'steps' is '0'"));
  EXPECT_THAT(failing(2, withStep(R"({"operator":"mark_mask","region":"hole"})")), HasSubstr("step 1: "));
  EXPECT_THAT(failing(1, withStep(R"({"operator":"misbehave"})")), HasSubstr("step 1: misbehave"));
  EXPECT_EQ(files(), (std::vector<std::string>{"example.ply", "recipe.json"}));
}

}  // namespace
}  // namespace stipple
