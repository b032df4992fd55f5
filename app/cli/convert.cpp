#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/files.h"

namespace stipple {
namespace {

struct ConvertOptions {
  std::string input, output;
  Encoding encoding = Encoding::kBinary;
};

Outcome runConvert(const ConvertOptions& options, Progress& progress) {
  checkPointsWritable(options.output);
  PartialProgress reading(progress, 0, 0.5), writing(progress, 0.5, 1);
  ReadResult read = readInput(options.input, reading);
  Outcome outcome{.warnings = std::move(read.warnings)};
  for (std::string& loss :
       writeOutput(options.output, read.points, {.encoding = options.encoding}, writing)) {
    outcome.warnings.push_back(std::move(loss));
  }
  return outcome;
}

}  // namespace

void addConvert(CLI::App& program, Command& chosen) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      program.add_subcommand("convert", "Write the points in another format, chosen by the name of OUT");
  command->add_option("IN", options->input, "File of points")->required();
  command->add_option("OUT", options->output, "File to write")->required();
  addChoice(
      *command, "--encoding", {"binary", "ascii"},
      [options](std::size_t choice) { options->encoding = static_cast<Encoding>(choice); },
      "For formats that know both (binary)");
  command->callback(
      [options, &chosen] { chosen = [options](Progress& p) { return runConvert(*options, p); }; });
}

}  // namespace stipple
