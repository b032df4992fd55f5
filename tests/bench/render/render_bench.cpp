// Pictures against the surfaces that they show, and times against a program that draws every point. Usage:
//   render_bench [quality|speed|popping|coverage|build|refit|memory]... [POINTS]
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <thread>

#include "render/raster/tile.h"
#include "tests/bench/render/workbench.h"

namespace stipple {
namespace {

struct Mode {
  const char* name;
  void (*print)(Workbench&);
};

constexpr std::array<Mode, 7> kModes{{{"memory", printMemory},
                                      {"build", printBuild},
                                      {"speed", printSpeed},
                                      {"refit", printRefit},
                                      {"quality", printQuality},
                                      {"popping", printPopping},
                                      {"coverage", printCoverage}}};

std::string machineName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

int run(int argc, char** argv) {
  BenchOptions options;
  std::set<std::string> wanted;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (const long count = std::strtol(word.c_str(), nullptr, 10); count > 0) {
      options.points = static_cast<Index>(count);
    } else if (std::ranges::count(kModes, word, &Mode::name)) {
      wanted.insert(word);
    } else {
      fmt::print(stderr, "render_bench [quality|speed|popping|coverage|build|refit|memory]... [POINTS]\n");
      return 2;
    }
  }
  fmt::print("{} points, {} x {}, {} threads of {}, {}\n", options.points, options.width, options.height,
             std::thread::hardware_concurrency(), machineName(), rasterInstructionSet());
  Workbench bench(options);
  for (const Mode& mode : kModes) {
    if (!wanted.empty() && !wanted.contains(mode.name)) continue;
    fmt::print("\n-- {}\n", mode.name);
    std::fflush(stdout);
    mode.print(bench);
  }
  return 0;
}

}  // namespace
}  // namespace stipple

int main(int argc, char** argv) {
  return stipple::run(argc, argv);
}
