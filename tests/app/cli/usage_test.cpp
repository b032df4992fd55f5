#include "tests/app/cli/cli_fixture.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::vector<std::string> kCommands = {"info", "convert", "discretize", "operators",
                                            "run",  "play",    "render",     "turntable"};

TEST_F(Cli, HelpAndVersionAreEverywhere) {
  EXPECT_THAT(run({"--version"}).out, StartsWith("stipple-cli "));
  const std::string help = run({"--help"}).out;
  for (const std::string& command : kCommands) {
    EXPECT_THAT(help, HasSubstr("\n  " + command + " "));
    const ProgramRun commandHelp = run({command, "--help"});
    EXPECT_EQ(commandHelp.exitCode, 0);
    EXPECT_THAT(commandHelp.out, HasSubstr("stipple-cli " + command));
    EXPECT_EQ(commandHelp.err, "");
    const ProgramRun version = run({command, "--version"});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_EQ(version.out, run({"--version"}).out);
  }
}

TEST_F(Cli, WrongUseIsExit2WithOneLine) {
  const std::string example = writeExample();
  EXPECT_THAT(failWith(2, {}), HasSubstr("required"));
  EXPECT_THAT(failWith(2, {"inform"}), HasSubstr("there is no command 'inform', expected one of info, "));
  EXPECT_THAT(failWith(2, {"--fast"}), HasSubstr("--fast"));
  EXPECT_THAT(failWith(2, {"info"}), HasSubstr("FILE is required"));
  EXPECT_THAT(failWith(2, {"info", example, "--yaml"}), HasSubstr("--yaml"));
  EXPECT_THAT(failWith(2, {"info", example, example}), HasSubstr("example.ply"));
  EXPECT_THAT(failWith(2, {"convert", example}), HasSubstr("OUT is required"));
  EXPECT_THAT(failWith(2, {"convert", example, path("o.ply"), "--encoding", "morse"}),
              HasSubstr("'morse' is not one of binary|ascii"));
  EXPECT_THAT(failWith(2, {"run", "stepper", example}), HasSubstr("--output is required"));
  EXPECT_THAT(failWith(2, {"play", "recipe.json", example}), HasSubstr("--output is required"));
  EXPECT_THAT(failWith(2, {"discretize", example, "--scheme", "1"}), HasSubstr("'1' is not one of voronoi|"));
  EXPECT_THAT(failWith(2, {"discretize", example, "--k", "many"}), HasSubstr("--k"));
}

TEST_F(Cli, AFullStdoutIsAFailure) {
  const std::string program = std::string(STIPPLE_BINARY_DIR) + "/bin/stipple-cli";
  const ProgramRun done = runProgram(program, {"info", writeExample()}, {.outputPath = "/dev/full"});
  EXPECT_EQ(done.exitCode, 3);
  EXPECT_EQ(countLines(done.err), 1);
}

// What every command that reads points says of a file that it cannot use.
TEST_F(Cli, FilesThatCannotBeReadAreExit3WithOneLine) {
  const std::string empty = write("empty.ply", "");
  const std::string noise = write("noise.bin", std::string("\x01\x02\x03\x00\x04", 5));
  const std::string corrupt =
      write("cut.ply",
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n1 2 3\n");
  const std::string noPoints =
      write("none.ply",
            "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n");
  const std::string allDropped = write("nan.ply",
                                       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                       "property float y\nproperty float z\nend_header\nnan 0 0\n");
  const std::string recipe = write("recipe.json", R"({"stipple_recipe":1,"steps":[]})");
  for (const std::string& file :
       {path("absent.ply"), folder_.string(), empty, noise, corrupt, noPoints, allDropped}) {
    for (const bool json : {false, true}) {
      std::vector<std::string> arguments = {"info", file};
      if (json) arguments.push_back("--json");
      EXPECT_THAT(failWith(3, arguments), HasSubstr(file));
    }
    EXPECT_THAT(failWith(3, {"convert", file, path("out.ply")}), HasSubstr(file));
    EXPECT_THAT(failWith(3, {"discretize", file, "--json"}), HasSubstr(file));
    EXPECT_THAT(failWith(3, {"run", "stepper", file, "-o", path("out.ply")}), HasSubstr(file));
    EXPECT_THAT(failWith(3, {"play", recipe, file, "-o", path("out.ply")}), HasSubstr(file));
    EXPECT_THAT(failWith(3, {"render", file, "-o", path("out.png")}), HasSubstr(file));
    EXPECT_THAT(failWith(3, {"turntable", file, "-o", path("around")}), HasSubstr(file));
  }
  EXPECT_FALSE(std::filesystem::exists(path("out.png")));
  EXPECT_FALSE(std::filesystem::exists(path("around")));
  EXPECT_FALSE(std::filesystem::exists(path("out.ply")));
}

TEST_F(Cli, UnwritableOutputIsExit3WithOneLineAndNothingLeftBehind) {
  const std::string example = writeExample();
  const std::string recipe = write("recipe.json", R"({"stipple_recipe":1,"steps":[]})");
  const auto before = files();
  for (const std::string& out : {path("no/such/folder/out.ply"), path("out.unknown"), path("out")}) {
    EXPECT_THAT(failWith(3, {"convert", example, out}), HasSubstr(out));
    EXPECT_THAT(failWith(3, {"run", "stepper", example, "-o", out}), HasSubstr(out));
    EXPECT_THAT(failWith(3, {"play", recipe, example, "-o", out}), HasSubstr(out));
  }
  for (const char* option : {"--stiffness", "--mass"}) {
    EXPECT_THAT(failWith(3, {"discretize", example, option, folder_.string()}), HasSubstr(folder_.string()));
    EXPECT_THAT(failWith(3, {"discretize", example, option, path("no/out.mtx")}), HasSubstr("no/out.mtx"));
  }
  EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace stipple
