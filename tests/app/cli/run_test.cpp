#include <nlohmann/json.hpp>

#include "tests/app/cli/cli_fixture.h"

namespace stipple {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(Cli, RunWritesTheResultAndReportsInJson) {
  const json report = runJson({"run", "stepper", writeExample(), "-o", path("out.ply"), "--set", "steps=3",
                               "--set", "amount=0.5", "--json"});
  EXPECT_EQ(report["steps"], 3);
  EXPECT_GE(report["seconds"], 0);
  EXPECT_GE(report["cpu_seconds"], 0);
  EXPECT_EQ(report["report"]["done"], 3);
  EXPECT_TRUE(report["report"]["not_a_number"].is_null());
  EXPECT_EQ(report["warnings"], json::array());
  const PointSet points = read("out.ply");
  EXPECT_THAT(points.values<float>("height"), ElementsAre(1.5, 1.5, 1.5, 1.5, 1.5));
  EXPECT_THAT(points.values<std::int32_t>("label"), ElementsAre(1, -2, 3, 4, 5));
}

TEST_F(Cli, RunWorksInTheRegion) {
  const std::string example = writeExample();
  EXPECT_EQ(run({"run", "mark_mask", example, "-o", path("out.ply"), "--region", "mask"}).exitCode, 0);
  EXPECT_THAT(read("out.ply").values<std::int32_t>("inside"), ElementsAre(0, 1, 0, 0, 1)) << "NaN is outside";
  EXPECT_EQ(run({"run", "mark_limits", example, "-o", path("out.ply")}).exitCode, 0);
  EXPECT_THAT(read("out.ply").values<std::int32_t>("inside"), ElementsAre(1, 1, 1, 1, 1));
}

TEST_F(Cli, RunKeepsTheOrderWhenPointsAreRemoved) {
  EXPECT_EQ(run({"run", "thin_out", writeExample(), "-o", path("out.ply")}).exitCode, 0);
  EXPECT_THAT(read("out.ply").values<std::int32_t>("label"), ElementsAre(1, 3, 5));
}

TEST_F(Cli, RunRefusesWrongUseBeforeReading) {
  const std::string out = path("out.ply"), absent = path("absent.ply");
  const auto using_ = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"run", "stepper", absent, "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  EXPECT_THAT(failWith(2, {"run", "polish", absent, "-o", out}), HasSubstr("there is no operator 'polish'"));
  EXPECT_THAT(failWith(2, using_({"--set", "speed=1"})), HasSubstr("there is no parameter 'speed'"));
  EXPECT_THAT(failWith(2, using_({"--set", "steps=0"})),
              HasSubstr("'steps' is '0', expected an integer from 1 to"));
  EXPECT_THAT(failWith(2, using_({"--set", "steps=two"})), HasSubstr("'steps' is 'two'"));
  EXPECT_THAT(failWith(2, using_({"--set", "tilt=91"})), HasSubstr("from 0 to 90 (degrees)"));
  EXPECT_THAT(failWith(2, using_({"--set", "steps"})), HasSubstr("id=value"));
  EXPECT_THAT(failWith(2, using_({"--fast"})), HasSubstr("--fast"));
}

TEST_F(Cli, RunRefusesRegionsAndAttributesThatAreNotThere) {
  const std::string example = writeExample(), out = path("out.ply");
  EXPECT_THAT(failWith(2, {"run", "mark_mask", example, "-o", out}), HasSubstr("needs a region"));
  EXPECT_THAT(failWith(2, {"run", "mark_mask", example, "-o", out, "--region", "hole"}), HasSubstr("'hole'"));
  EXPECT_THAT(failWith(2, {"run", "stepper", example, "-o", out, "--region", "mask"}),
              HasSubstr("takes no region"));
  EXPECT_THAT(failWith(2, {"run", "stepper", example, "-o", out, "--set", "like=heat"}), HasSubstr("'heat'"));
  EXPECT_EQ(files(), std::vector<std::string>{"example.ply"});
}

TEST_F(Cli, AFailedOperatorIsExit1WithOneLineAndLeavesNothing) {
  const std::string example = writeExample();
  for (const std::string how : {"standard", "invalid_input", "number", "memory", "lose_points"}) {
    EXPECT_THAT(
        failWith(1, {"run", "misbehave", example, "-o", path("out.ply"), "--set", "how=" + how, "--json"}),
        HasSubstr("misbehave"));
  }
  EXPECT_EQ(files(), std::vector<std::string>{"example.ply"});
}

TEST_F(Cli, RunPassesWarningsOn) {
  const std::string example = writeExample();
  const json report =
      runJson({"run", "stepper", example, "-o", path("out.ply"), "--set", "amount=0", "--json"});
  EXPECT_EQ(report["warnings"], json({"nothing was added"}));
  const ProgramRun plain = run({"run", "stepper", example, "-o", path("out.ply"), "--set", "amount=0"});
  EXPECT_THAT(plain.err, HasSubstr("nothing was added"));
}

TEST_F(Cli, CtrlCIsExit130AndLeavesNothing) {
  const ProgramRun stopped = run({"run", "stepper", writeExample(), "-o", path("out.ply"), "--set",
                                  "steps=100000", "--set", "milliseconds=5", "--json"},
                                 400);
  EXPECT_EQ(stopped.exitCode, 130);
  EXPECT_EQ(stopped.out, "");
  EXPECT_EQ(countLines(stopped.err), 1);
  EXPECT_EQ(files(), std::vector<std::string>{"example.ply"});
}

}  // namespace
}  // namespace stipple
