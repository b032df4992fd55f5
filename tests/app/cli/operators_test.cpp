#include <nlohmann/json.hpp>

#include "tests/app/cli/cli_fixture.h"

namespace stipple {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST_F(Cli, OperatorsListsEverythingThatWasDeclared) {
  const json document = runJson({"operators", "--json"});
  json stepper;
  for (const json& op : document["operators"]) {
    if (op["id"] == "stepper") stepper = op;
  }
  EXPECT_EQ(stepper["title"], "Stepper");
  EXPECT_THAT(stepper["help"].get<std::string>(), HasSubstr("step by step"));
  EXPECT_EQ(stepper["region"], "none");
  EXPECT_EQ(stepper["writes"], json({"height"}));
  EXPECT_EQ(stepper["parameters"][0], (json{{"id", "steps"},
                                            {"title", ""},
                                            {"type", "int"},
                                            {"unit", ""},
                                            {"default", 4},
                                            {"min", 1},
                                            {"max", 100000},
                                            {"choices", json::array()},
                                            {"help", ""}}));
  EXPECT_EQ(stepper["parameters"][3]["unit"], "degrees");
  EXPECT_EQ(stepper["parameters"][3]["default"], 30.0);
  EXPECT_TRUE(stepper["parameters"][1]["min"].is_null());
}

TEST_F(Cli, OperatorsListsRegionsAndChoices) {
  const json document = runJson({"operators", "--json"});
  for (const json& op : document["operators"]) {
    if (op["id"] == "mark_limits") {
      EXPECT_EQ(op["region"], "limits");
    }
    if (op["id"] == "mark_mask") {
      EXPECT_EQ(op["region"], "mask");
    }
    if (op["id"] == "misbehave") {
      EXPECT_EQ(op["parameters"][0]["choices"].size(), 5u);
    }
  }
  EXPECT_THAT(run({"operators"}).out, HasSubstr("stepper: Adds an amount"));
}

TEST_F(Cli, PluginsThatCannotBeLoadedAreWarnings) {
  write("notes.txt", "not a plugin");
  const std::string program = std::string(STIPPLE_BINARY_DIR) + "/bin/stipple-cli";
  const ProgramOptions options{.environment = {"STIPPLE_PLUGIN_PATH=" + folder_.string()}};
  const json document = json::parse(runProgram(program, {"operators", "--json"}, options).out);
  ASSERT_EQ(document["warnings"].size(), 1u);
  EXPECT_THAT(document["warnings"][0].get<std::string>(), HasSubstr("notes.txt"));
  EXPECT_THAT(runProgram(program, {"operators"}, options).err, HasSubstr("notes.txt"));
  const ProgramRun failed = runProgram(program, {"run", "nothing", "in.ply", "-o", "out.ply"}, options);
  EXPECT_EQ(countLines(failed.err), 1) << failed.err;
}

}  // namespace
}  // namespace stipple
