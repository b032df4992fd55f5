#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/command.h"
#include "app/cli/files.h"
#include "app/cli/matrix_market.h"
#include "core/fem/assembly.h"
#include "core/geometry/fan_votes.h"
#include "core/stopwatch.h"

namespace stipple {
namespace {

using Json = nlohmann::ordered_json;

struct DiscretizeOptions {
  std::string input, stiffness, mass;
  DiscretizationOptions discretization;
  double minAngleDegrees = 0;
  int threads = 0;
  bool json = false;
};

// Seconds of the stages in their order, and of the whole program so far.
class StageTimes {
 public:
  void add(const char* stage, const StageTime& time) {
    seconds_[stage] = time.seconds;
    cpuSeconds_[stage] = time.cpuSeconds;
  }
  void add(const char* stage, const Stopwatch& watch) {
    add(stage, {.seconds = watch.seconds(), .cpuSeconds = watch.cpuSeconds()});
  }
  void finish() {
    add("total", {.seconds = sinceStart_.seconds(),
                  .cpuSeconds = Stopwatch::processorSeconds(CLOCK_PROCESS_CPUTIME_ID)});
  }
  const Json& seconds() const { return seconds_; }
  const Json& cpuSeconds() const { return cpuSeconds_; }

 private:
  Stopwatch sinceStart_;
  Json seconds_ = Json::object(), cpuSeconds_ = Json::object();
};

double shareOf(const std::vector<std::uint8_t>& marks) {
  if (marks.empty()) return 0;
  return static_cast<double>(std::ranges::count_if(marks, [](auto mark) { return mark != 0; })) /
         static_cast<double>(marks.size());
}

std::uint64_t peakBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts kibibytes
}

// The matrices in the order of the file, written where asked for.
void assembleAndWrite(const DiscretizeOptions& options, const Discretization& d, StageTimes& times,
                      Progress& progress) {
  const Stopwatch assembly;
  const SparseMatrix stiffness = assembleStiffness(d, &progress);
  const std::vector<double> mass = expandMassToPoints(d.sites, d.mass);
  times.add("assembly", {.seconds = d.times.assembly.seconds + assembly.seconds(),
                         .cpuSeconds = d.times.assembly.cpuSeconds + assembly.cpuSeconds()});
  const Stopwatch writing;
  if (!options.stiffness.empty()) writeSymmetric(options.stiffness, PointRows(d.sites, stiffness), progress);
  if (!options.mass.empty()) writeDiagonal(options.mass, mass, progress);
  if (!options.stiffness.empty() || !options.mass.empty()) times.add("write", writing);
}

Json describe(const Discretization& d, const StageTimes& times) {
  return {{"points", d.sites.siteOfPoint.size()},
          {"seconds", times.seconds()},
          {"cpu_seconds", times.cpuSeconds()},
          {"peak_bytes", peakBytes()},
          {"open_fans", shareOf(d.fans.open)},
          {"certified", shareOf(d.fans.certified)},
          {"consistent_triangles", shareOfConsistentTriangles(d.fans)}};
}

std::string asText(const Json& json) {
  std::string text = fmt::format("points                {}\n", json["points"].dump());
  for (const auto& [stage, seconds] : json["seconds"].items()) {
    text += fmt::format("{:<21} {:.3f} s, {:.3f} s of processor\n", stage, seconds.get<double>(),
                        json["cpu_seconds"][stage].get<double>());
  }
  text += fmt::format("peak                  {:.1f} MB\n", json["peak_bytes"].get<double>() / 1e6);
  for (const char* share : {"open_fans", "certified", "consistent_triangles"}) {
    text += fmt::format("{:<21} {:.4f} %\n", share, 100 * json[share].get<double>());
  }
  return text;
}

void checkUsage(const DiscretizeOptions& options) {
  try {
    checkOptions(options.discretization);
  } catch (const InvalidInput& error) {
    throw CommandFailure(kUsage, error.what());
  }
  for (const std::string& output : {options.stiffness, options.mass}) {
    if (!output.empty()) checkWritable(output);
  }
}

Outcome runDiscretize(DiscretizeOptions options, Progress& progress) {
  StageTimes times;
  options.discretization.minAngle = options.minAngleDegrees * std::numbers::pi / 180;
  checkUsage(options);
  const ThreadLimit threads(options.threads);

  const Stopwatch reading;
  PartialProgress readProgress(progress, 0, 0.3), fanProgress(progress, 0.3, 0.8),
      matrixProgress(progress, 0.8, 1);
  ReadResult read = readInput(options.input, readProgress);
  times.add("read", reading);

  const Discretization d = discretize(read.points, options.discretization, fanProgress);
  times.add("order", d.times.order);
  times.add("neighbors", d.times.neighbors);
  times.add("frames", d.times.frames);
  times.add("fans", d.times.fans);
  times.add("consensus", d.times.consensus);

  assembleAndWrite(options, d, times, matrixProgress);
  times.finish();
  const Json json = describe(d, times);
  return makeOutcome(options.json, json, asText(json), std::move(read.warnings));
}

}  // namespace

void addDiscretize(CLI::App& program, Command& chosen) {
  const auto options = std::make_shared<DiscretizeOptions>();
  DiscretizationOptions& d = options->discretization;
  CLI::App* command = program.add_subcommand("discretize", "Build the finite-element matrices of the points");
  command->add_option("IN", options->input, "File of points")->required();
  command->add_flag("--json", options->json, "Print one JSON document");
  command->add_option("--stiffness", options->stiffness, "Write the stiffness matrix L (MatrixMarket)")
      ->type_name("FILE");
  command->add_option("--mass", options->mass, "Write the diagonal mass matrix M (MatrixMarket)")
      ->type_name("FILE");
  command->add_option("--k", d.k, "Neighbors a fan starts with, 6 to 1000 (0: by itself)");
  // The words stand in the order of the enumerations.
  addChoice(
      *command, "--scheme", {"voronoi", "element", "paper", "mesh"},
      [&d](std::size_t choice) { d.scheme = static_cast<Scheme>(choice); },
      "How matrices come from the points (voronoi)");
  addChoice(
      *command, "--metric", {"unfolded", "projected"},
      [&d](std::size_t choice) { d.metric = static_cast<Metric>(choice); },
      "Where neighbors lie in the tangent plane (unfolded)");
  addChoice(
      *command, "--consensus", {"on", "off"}, [&d](std::size_t choice) { d.consensus = choice == 0; },
      "Bring neighboring fans to agreement (on)");
  command->add_option("--min-angle", options->minAngleDegrees, "Degrees; drops thin triangles (0)");
  command->add_option("--threads", options->threads, "Most threads to use (0: all cores)")
      ->check(CLI::Range(0, 4096));
  command->callback(
      [options, &chosen] { chosen = [options](Progress& p) { return runDiscretize(*options, p); }; });
}

}  // namespace stipple
