// Patterns on the bunny at the numbers of steps of the paper, without reading and writing: a tenth of its
// times is asked for. The plain loop over an array tells machines, and what else runs there, apart.
#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "core/io/point_io.h"
#include "core/stopwatch.h"
#include "tests/plugins/texture_synthesis/grown_patterns.h"

namespace stipple {
namespace {

struct Timing {
  double setup = std::numeric_limits<double>::max(), steps = setup, cpuSteps = setup;
};

// The best of five; the first step prepares the surface.
Timing timePattern(const PointSet& points, const char* pattern, std::int64_t count) {
  Timing best;
  Progress progress;
  for (int attempt = 0; attempt < 5; ++attempt) {
    const auto run = makeTextureSynthesis()->start(
        points, Region(), textureSettings({{"pattern", std::string(pattern)}, {"steps", count}}));
    const Stopwatch setup;
    run->step(progress);
    best.setup = std::min(best.setup, setup.seconds());
    const Stopwatch steps;
    while (!run->step(progress).finished) {
    }
    best.steps = std::min(best.steps, steps.seconds());
    best.cpuSteps = std::min(best.cpuSteps, steps.cpuSeconds());
  }
  return best;
}

// One thread, 1000 passes over as many pairs of floats as a step holds: what one pass without a matrix takes.
double timePlainLoop(std::size_t sites) {
  std::vector<float> from(2 * sites, 1), to(2 * sites, 0);
  double best = std::numeric_limits<double>::max();
  for (int attempt = 0; attempt < 5; ++attempt) {
    const Stopwatch watch;
    for (int pass = 0; pass < 1000; ++pass) {
      for (std::size_t i = 0; i < to.size(); ++i) to[i] = 0.5f * (to[i] + from[i]);
      from.swap(to);
    }
    best = std::min(best, watch.seconds());
  }
  return best;
}

void printTable() {
  const auto path = std::filesystem::path(STIPPLE_TEST_DATA) / "smooth/bun_zipper_binary_le_points.ply";
  if (!std::filesystem::exists(path)) return fmt::print("{} is not here\n", path.string());
  Progress progress;
  const PointSet bunny = readPoints(path, progress).points;
  fmt::print("{} points; 1000 plain passes {:.3f} s\n", bunny.size(), timePlainLoop(bunny.size()));
  fmt::print("pattern  steps  setup s  steps s  processor s  s per 1000  asked for, all\n");
  struct Row {
    const char* pattern;
    std::int64_t steps;
    double most;
  };
  for (const Row& row : {Row{"spots", 1700, 3.0}, Row{"stripes", 600, 0.8}, Row{"zebra", 1300, 1.8}}) {
    const Timing t = timePattern(bunny, row.pattern, row.steps);
    fmt::print("{:<8} {:>5} {:>8.2f} {:>8.2f} {:>12.2f} {:>11.2f} {:>15.1f}\n", row.pattern, row.steps,
               t.setup, t.steps, t.cpuSteps, 1000 * t.steps / static_cast<double>(row.steps), row.most);
  }
}

}  // namespace
}  // namespace stipple

int main() {
  stipple::printTable();
}
