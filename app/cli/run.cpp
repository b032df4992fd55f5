#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/files.h"
#include "app/document/invocation.h"
#include "app/plugins/loader.h"
#include "core/stopwatch.h"

namespace stipple {
namespace {

using Json = nlohmann::ordered_json;

struct RunOptions {
  std::string operatorId, input, output, region;
  std::vector<std::string> assignments;
  bool json = false;
};

Json describe(const Report& report) {
  Json json = Json::object();
  for (const auto& [name, value] : report.values) {
    std::visit([&](const auto& held) { json[name] = held; }, value);
  }
  return json;
}

Invocation readInvocation(const RunOptions& options, const Registry& registry) {
  Invocation invocation = makeInvocation(registry, options.operatorId);
  invocation.region = options.region;
  try {
    for (const std::string& assignment : options.assignments)
      invocation.parameters.setFromAssignment(assignment);
  } catch (const InvalidInput& error) {
    throw CommandFailure(kUsage, fmt::format("{}: {}", options.operatorId, error.what()));
  }
  return invocation;
}

void append(std::vector<std::string>& warnings, const std::vector<std::string>& more) {
  warnings.insert(warnings.end(), more.begin(), more.end());
}

Outcome runOperator(const RunOptions& options, Progress& progress) {
  const LoadedPlugins plugins = loadPlugins(pluginFolders());
  const Invocation invocation = readInvocation(options, plugins.registry);
  checkPointsWritable(options.output);
  std::vector<std::string> warnings = plugins.warnings;

  PartialProgress reading(progress, 0, 0.1), running(progress, 0.1, 0.9), writing(progress, 0.9, 1);
  const ReadResult read = readInput(options.input, reading);
  append(warnings, read.warnings);

  const Stopwatch watch;
  const InvocationResult done = invoke(plugins.registry, invocation, read.points, running);
  const double seconds = watch.seconds(), cpuSeconds = watch.cpuSeconds();
  append(warnings, done.report.warnings);
  append(warnings, writeOutput(options.output, done.result.points, {}, writing));

  const Json report = describe(done.report);
  std::string text = fmt::format("{}: {} steps, {:.3f} s, {:.3f} s of processor\n", options.operatorId,
                                 done.steps, seconds, cpuSeconds);
  for (const auto& [name, value] : report.items()) text += fmt::format("{}: {}\n", name, value.dump());
  return makeOutcome(options.json,
                     {{"operator", options.operatorId},
                      {"points", done.result.points.size()},
                      {"seconds", seconds},
                      {"cpu_seconds", cpuSeconds},
                      {"steps", done.steps},
                      {"report", report}},
                     std::move(text), std::move(warnings));
}

}  // namespace

void addRun(CLI::App& program, Command& chosen) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = program.add_subcommand("run", "Run an operator on a file of points");
  command->add_option("OPERATOR", options->operatorId, "Its id; `stipple-cli operators` lists them")
      ->required();
  command->add_option("IN", options->input, "File of points")->required();
  command->add_option("-o,--output", options->output, "File to write")->required()->type_name("OUT");
  command->add_option("--set", options->assignments, "Set a parameter; may be repeated")
      ->type_name("ID=VALUE")
      ->allow_extra_args(false);
  command->add_option("--region", options->region, "Work where this attribute is not 0")
      ->type_name("ATTRIBUTE");
  command->add_flag("--json", options->json, "Print one JSON document");
  command->callback(
      [options, &chosen] { chosen = [options](Progress& p) { return runOperator(*options, p); }; });
}

}  // namespace stipple
