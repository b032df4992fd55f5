#include <fmt/format.h>

#include <cstring>

#include "core/io/input_file.h"
#include "core/io/point_io.h"
#include "render/hierarchy/closedness.h"
#include "tests/bench/render/workbench.h"
#include "tests/support/sampled_hierarchy.h"

namespace stipple {

namespace {

/// Binary PLY: position, normal, color; 27 bytes a point.
std::vector<std::byte> plyBytes(const scenes::SurfaceSamples& samples) {
  std::string header =
      fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", samples.positions.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    header += fmt::format("property float {}\n", name);
  for (const char* name : {"red", "green", "blue"}) header += fmt::format("property uchar {}\n", name);
  header += "end_header\n";
  constexpr std::size_t kRow = 27;
  std::vector<std::byte> bytes(header.size() + kRow * samples.positions.size());
  std::memcpy(bytes.data(), header.data(), header.size());
  for (std::size_t i = 0; i < samples.positions.size(); ++i) {
    std::byte* row = bytes.data() + header.size() + kRow * i;
    std::memcpy(row, samples.positions[i].data(), 12);
    std::memcpy(row + 12, samples.normals[i].data(), 12);
    std::memcpy(row + 24, &samples.colors[i], 3);
  }
  return bytes;
}

/// Alpha says how much is selected.
RawVector<Rgba8> unselected(std::span<const Rgba8> colors) {
  RawVector<Rgba8> result(colors.size());
  parallelFor(colors.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = {colors[i].r, colors[i].g, colors[i].b, 0};
  });
  return result;
}

struct FirstPicture {
  Times parse, build, draw, whole;
  std::size_t splats = 0;
};

void openOnce(Workbench& bench, const std::vector<std::byte>& bytes, FirstPicture& times) {
  const Stopwatch whole;
  Progress progress;
  const InputFile file("points.ply", bytes);
  const ReadResult read = readPoints(file, progress);
  times.parse.add(whole);
  const Stopwatch building;
  LeafAttributes leaves;
  leaves.positions = read.points.positions();
  leaves.normals = read.points.values<Eigen::Vector3f>("normal");
  const RawVector<Rgba8> colors = unselected(read.points.values<Rgba8>("color"));
  leaves.colors = colors;
  const Hierarchy hierarchy = buildHierarchy(leaves, LeafOrder::kMorton);
  times.build.add(building);
  const Stopwatch drawing;
  const View view = bench.view();
  const Cut cut = selectCut(hierarchy, view, {.tau = 4});
  CpuRenderer renderer;
  renderer.upload(hierarchy, {{0, hierarchy.nodeCount()}});
  renderer.draw(hierarchy, cut.nodes, view, bench.appearance, Accumulate::kStartAnew, nullptr);
  const Image image = renderer.image();
  times.draw.add(drawing);
  times.whole.add(whole);
  times.splats = cut.nodes.size();
}

}  // namespace

void printBuild(Workbench& bench) {
  const int repetitions = std::min(3, bench.options.repetitions);
  for (const LeafOrder order : {LeafOrder::kMorton, LeafOrder::kKd}) {
    Times ordering, whole, refitting;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
      const Stopwatch orderWatch;
      orderLeaves(bench.samples().positions, order);
      ordering.add(orderWatch);
      const Stopwatch watch;
      Hierarchy hierarchy = buildHierarchy(leavesOf(bench.samples()), order);
      whole.add(watch);
      const Stopwatch refitWatch;
      refitAll(hierarchy);
      refitting.add(refitWatch);
    }
    fmt::print(
        "{:<7} order {:.0f} ms; whole hierarchy least {:.0f}, median {:.0f} ms ({:.0f} cpu); of these all "
        "inner nodes {:.0f}\n",
        order == LeafOrder::kKd ? "kd" : "Morton", ordering.median(), whole.least(), whole.median(),
        whole.medianCpu(), refitting.median());
    std::fflush(stdout);
  }
  const PointSet points(bench.samples().positions);
  const Stopwatch asking;
  const bool isClosed = isClosedAndOriented(points, bench.hierarchy());
  fmt::print("closed and oriented: {}, found in {:.0f} ms\n", isClosed ? "yes" : "no",
             1e3 * asking.seconds());
  const std::vector<std::byte> bytes = plyBytes(bench.samples());
  FirstPicture times;
  for (int repetition = 0; repetition < repetitions; ++repetition) openOnce(bench, bytes, times);
  fmt::print(
      "first picture: parse {:.0f} + Morton hierarchy {:.0f} + tau 4, {} splats {:.0f} = least {:.0f}, "
      "median {:.0f} ms ({:.0f} cpu)\n",
      times.parse.median(), times.build.median(), times.splats, times.draw.median(), times.whole.least(),
      times.whole.median(), times.whole.medianCpu());
}

void printMemory(Workbench& bench) {
  const Hierarchy& hierarchy = bench.hierarchy();
  fmt::print("hierarchy, splats, both maps: {:.2f} bytes a point ({} nodes, {} levels)\n",
             static_cast<double>(hierarchy.memoryBytes()) / bench.options.points, hierarchy.nodeCount(),
             hierarchy.levelCount());
}

}  // namespace stipple
