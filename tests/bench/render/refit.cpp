#include <fmt/format.h>

#include <random>

#include "render/hierarchy/pick.h"
#include "tests/bench/render/workbench.h"

namespace stipple {

namespace {

constexpr Index kTouched = 20'000;

/// The points of a ball on the surface that holds about `count` of them.
std::vector<Index> slotsOfDab(const Hierarchy& hierarchy, const scenes::Scene& scene, Index count) {
  const Splat& middle = hierarchy.splats()[hierarchy.slotOfPoint[hierarchy.leafCount() / 3]];
  float radius = static_cast<float>(scene.spacing(hierarchy.leafCount()) * std::sqrt(count / M_PI));
  std::vector<Index> slots;
  while (slots.size() < count) {
    slots = findInBall(hierarchy, {middle.center(), radius});
    radius *= 1.02f;
  }
  slots.resize(count);
  return slots;
}

std::vector<Index> slotsAnywhere(const Hierarchy& hierarchy, Index count) {
  std::mt19937 random(3);
  std::vector<Index> slots(count);
  for (Index& slot : slots) slot = static_cast<Index>(random() % hierarchy.leafCount());
  return slots;
}

void paint(Hierarchy& hierarchy, std::span<const Index> slots, int round) {
  for (const Index slot : slots)
    hierarchy.editSplats()[slot].color = {static_cast<std::uint8_t>(40 * round), 90, 200, 0};
}

/// From the touch of a brush to the picture: the whole of it with a new cut, or the tiles that differ.
enum class After { kCutAndDraw, kRedraw };

void printDab(Workbench& bench, const std::vector<Index>& slots, float tau, After after) {
  Hierarchy& hierarchy = bench.hierarchy();
  CutMemory memory;
  const View view = bench.view();
  Times whole, refitting, drawing;
  std::size_t splats = 0;
  const auto cutAndDraw = [&] {
    const Cut cut = selectCut(hierarchy, view, {.tau = tau}, &memory);
    bench.renderer.draw(hierarchy, cut.nodes, view, bench.appearance, Accumulate::kStartAnew, nullptr);
    splats = cut.nodes.size();
  };
  cutAndDraw();
  for (int round = -1; round < 2 * bench.options.repetitions; ++round) {
    if (round == 0) whole = refitting = drawing = {};
    const Stopwatch watch;
    paint(hierarchy, slots, round);
    const Stopwatch refitWatch;
    const std::vector<NodeRange> changed = refit(hierarchy, slots);
    refitting.add(refitWatch);
    bench.renderer.upload(hierarchy, changed);
    const Stopwatch drawWatch;
    if (after == After::kRedraw) {
      bench.renderer.redraw(hierarchy, changed);
    } else {
      cutAndDraw();
    }
    drawing.add(drawWatch);
    const Image image = bench.renderer.image();
    whole.add(watch);
  }
  fmt::print(
      "dab of {} points to pixels, {}, tau {} ({} splats): least {:.1f}, median {:.1f} ms ({:.1f} cpu); "
      "refit {:.2f}, {:.1f}\n",
      slots.size(), after == After::kRedraw ? "redraw" : "cut and draw", tau, splats, whole.least(),
      whole.median(), whole.medianCpu(), refitting.median(), drawing.median());
}

}  // namespace

void printRefit(Workbench& bench) {
  Hierarchy& hierarchy = bench.hierarchy();
  const Index touched = std::min(kTouched, hierarchy.leafCount() / 10);
  const std::vector<Index> dab = slotsOfDab(hierarchy, bench.torus, touched);
  const auto measure = [&](const char* where, const std::vector<Index>& slots) {
    Times times;
    std::size_t ranges = 0, nodes = 0;
    for (int round = 0; round < 4 * bench.options.repetitions; ++round) {
      const Stopwatch watch;
      const std::vector<NodeRange> changed = refit(hierarchy, slots);
      times.add(watch);
      ranges = changed.size();
      nodes = 0;
      for (const NodeRange& range : changed) nodes += range.end - range.begin;
    }
    fmt::print("refit of {} points {}: least {:.2f}, median {:.2f} ms ({:.2f} cpu); {} nodes in {} ranges\n",
               slots.size(), where, times.least(), times.median(), times.medianCpu(), nodes, ranges);
  };
  measure("in a ball", dab);
  measure("anywhere", slotsAnywhere(hierarchy, touched));
  const std::vector<Splat> before(hierarchy.splats().begin(),
                                  hierarchy.splats().begin() + hierarchy.leafCount());
  for (const float tau : {3.f, 4.f, 6.f}) {
    printDab(bench, dab, tau, After::kCutAndDraw);
    printDab(bench, dab, tau, After::kRedraw);
  }
  std::ranges::copy(before, hierarchy.editSplats().begin());
  refitAll(hierarchy);
}

}  // namespace stipple
