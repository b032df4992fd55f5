#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/files.h"
#include "app/document/recipe.h"
#include "app/plugins/loader.h"

namespace stipple {
namespace {

struct PlayOptions {
  std::string recipe, input, output;
};

Recipe readRecipe(const std::string& path, const Registry& registry) {
  const std::string text = readTextFile(path);
  try {
    return parseRecipe(text, registry);
  } catch (const UsageError& error) {
    throw CommandFailure(kUsage, fmt::format("{}: {}", path, error.what()));
  } catch (const InvalidInput& error) {
    throw CommandFailure(kFile, fmt::format("{}: {}", path, error.what()));
  }
}

Outcome playRecipe(const PlayOptions& options, Progress& progress) {
  const LoadedPlugins plugins = loadPlugins(pluginFolders());
  const Recipe recipe = readRecipe(options.recipe, plugins.registry);
  checkPointsWritable(options.output);

  PartialProgress reading(progress, 0, 0.1), playing(progress, 0.1, 0.9), writing(progress, 0.9, 1);
  const ReadResult read = readInput(options.input, reading);
  const PlayResult played = play(recipe, plugins.registry, read.points, playing);
  Outcome outcome{.warnings = plugins.warnings};
  const auto losses = writeOutput(options.output, played.points, {}, writing);
  for (const auto* more : {&read.warnings, &played.warnings, &losses}) {
    outcome.warnings.insert(outcome.warnings.end(), more->begin(), more->end());
  }
  return outcome;
}

}  // namespace

void addPlay(CLI::App& program, Command& chosen) {
  const auto options = std::make_shared<PlayOptions>();
  CLI::App* command = program.add_subcommand("play", "Do the steps of a recipe to a file of points");
  command->add_option("RECIPE", options->recipe, "Recipe (JSON)")->required();
  command->add_option("IN", options->input, "File of points")->required();
  command->add_option("-o,--output", options->output, "File to write")->required()->type_name("OUT");
  command->callback(
      [options, &chosen] { chosen = [options](Progress& p) { return playRecipe(*options, p); }; });
}

}  // namespace stipple
