#include <fmt/format.h>

#include <array>

#include "render/hierarchy/hidden_nodes.h"
#include "tests/bench/render/naive_points.h"
#include "tests/bench/render/workbench.h"

namespace stipple {

namespace {

/// Ours with one threshold; the model is known to be closed, or not.
struct Contestant {
  float tau;
  bool isClosed;
  CutMemory memory;
  Times cut = {}, draw = {}, whole = {};
  std::size_t splats = 0;
  PictureErrors errors = {};
};

std::vector<Contestant> contestants() {
  std::vector<Contestant> all;
  for (const bool isClosed : {false, true}) {
    for (const float tau : {3.f, 4.f, 6.f, 8.f, 10.f}) all.push_back({tau, isClosed, {}});
  }
  return all;
}

/// From the view to the picture in memory.
void drawOurs(Workbench& bench, Contestant& ours, const View& view) {
  Hierarchy& hierarchy = bench.hierarchy();
  hierarchy.isClosedAndOriented = ours.isClosed;
  const Stopwatch whole;
  const Cut cut = selectCut(hierarchy, view, {.tau = ours.tau}, &ours.memory);
  ours.cut.add(whole);
  const Stopwatch draw;
  bench.renderer.draw(hierarchy, cut.nodes, view, bench.appearance, Accumulate::kStartAnew, nullptr);
  ours.draw.add(draw);
  const Image image = bench.renderer.image();
  ours.whole.add(whole);
  ours.splats = cut.nodes.size();
}

struct Baseline {
  const char* name;
  NaivePoints points;
  Times times = {};
  PictureErrors errors = {};
};

void compare(Workbench& bench, std::span<Baseline* const> naive, std::span<Contestant> ours) {
  const Rgba8 background = *bench.appearance.background;
  // The camera turns a little from round to round; the last round stands where the reference was cast. The
  // first one compiles shaders and fills memories, and does not count.
  for (int round = -1; round < bench.options.repetitions; ++round) {
    const View view = bench.view(0.004f * static_cast<float>(bench.options.repetitions - 1 - round));
    for (Baseline* baseline : naive) {
      const Stopwatch watch;
      baseline->points.draw(view, background);
      if (round < 0) continue;
      baseline->times.add(watch);
      if (round + 1 == bench.options.repetitions) {
        baseline->errors = comparePictures(bench.reference(), baseline->points.picture(), kNoDepth);
      }
    }
    for (Contestant& contestant : ours) {
      if (round == 0) contestant.cut = contestant.draw = contestant.whole = {};
      drawOurs(bench, contestant, view);
      if (round + 1 < bench.options.repetitions) continue;
      contestant.errors = comparePictures(bench.reference(), takePicture(bench.renderer),
                                          3 * static_cast<float>(bench.torus.spacing(bench.options.points)));
    }
  }
}

void printTable(std::span<Baseline* const> naive, std::span<const Contestant> ours) {
  fmt::print("{:<22} {:>9} {:>15} {:>8} {:>6} {:>6} {:>6} {:>6}\n", "naive GL_POINTS", "", "ms least/median",
             "cpu ms", "PSNR", "edges", "SSIM", "holes");
  for (const Baseline* b : naive) {
    fmt::print("{:<22} {:>9} {:>7.0f}/{:<7.0f} {:>8.0f} {:>6.2f} {:>6.2f} {:>6.3f} {:>6}\n", b->name, "",
               b->times.least(), b->times.median(), b->times.medianCpu(), b->errors.psnr,
               b->errors.psnrWithEdges, b->errors.ssim, b->errors.holes);
  }
  fmt::print("{:<22} {:>9} {:>15} {:>8} {:>6} {:>6} {:>6} {:>6} {:>4} {:>5} {:>10} {:>6} {:>14} {:>14}\n",
             "ours: cut, draw, image", "splats", "ms least/median", "cpu ms", "PSNR", "edges", "SSIM",
             "holes", "back", "fringe", "cut/draw", "gain", "R file l/m/cpu", "R Morton");
  for (const Contestant& c : ours) {
    const auto ratio = [&c](const Baseline* b) {
      return fmt::format("{:.1f}/{:.1f}/{:.1f}", b->times.least() / c.whole.least(),
                         b->times.median() / c.whole.median(), b->times.medianCpu() / c.whole.medianCpu());
    };
    fmt::print(
        "tau {:<4} {:<13} {:>9} {:>7.1f}/{:<7.1f} {:>8.1f} {:>6.2f} {:>6.2f} {:>6.3f} {:>6} {:>4} {:>5} "
        "{:>4.1f}/{:<5.1f} {:>+6.2f} {:>14} {:>14}\n",
        c.tau, c.isClosed ? "known closed" : "", c.splats, c.whole.least(), c.whole.median(),
        c.whole.medianCpu(), c.errors.psnr, c.errors.psnrWithEdges, c.errors.ssim, c.errors.holes,
        c.errors.seeThrough, c.errors.fringe, c.cut.median(), c.draw.median(),
        c.errors.psnr - naive[0]->errors.psnr, ratio(naive[0]), ratio(naive[1]));
  }
}

/// Sixteen jittered frames, from scratch.
void printConvergence(Workbench& bench) {
  for (const bool isClosed : {false, true}) {
    Hierarchy& hierarchy = bench.hierarchy();
    hierarchy.isClosedAndOriented = isClosed;
    Times first, all;
    float tau = 3;
    for (int repetition = 0; repetition < 3; ++repetition) {
      const Stopwatch watch;
      const Cut cut = selectCut(hierarchy, bench.view(), {});
      bench.renderer.draw(hierarchy, cut.nodes, bench.view(), bench.appearance, Accumulate::kStartAnew,
                          nullptr);
      const Image converged = bench.renderer.image();
      first.add(watch);
      const Stopwatch mean;
      tau = tauOfMean(cut.tau,
                      withoutHidden(hierarchy, cut.nodes, bench.view(), bench.renderer.depth()).size());
      drawMeanOfFrames(bench, hierarchy, bench.view(), tau, 16);
      const Image image = bench.renderer.image();
      all.add(mean);
    }
    const PictureErrors errors = comparePictures(bench.reference(), takePicture(bench.renderer), kNoDepth);
    fmt::print(
        "converged (tau 3) {:.0f} ms, 16 frames at tau {:.2g} accumulated {:.0f} ms{}: {:.2f} dB, with edges "
        "{:.2f}, SSIM {:.3f}\n",
        first.median(), tau, all.median(), isClosed ? ", known closed" : "", errors.psnr,
        errors.psnrWithEdges, errors.ssim);
  }
  bench.hierarchy().isClosedAndOriented = false;
}

}  // namespace

void printSpeed(Workbench& bench) {
  std::vector<Index> morton;
  for (const PlacedPoint& p : orderLeaves(bench.samples().positions, LeafOrder::kMorton))
    morton.push_back(p.point);
  Baseline asInFile{"file order (random)", {bench.samples(), {}}},
      inOrder{"Morton order", {bench.samples(), morton}};
  fmt::print("{}\n", asInFile.points.device());
  std::vector<Contestant> ours = contestants();
  const std::array<Baseline*, 2> naive{&asInFile, &inOrder};
  compare(bench, naive, ours);
  printTable(naive, ours);
  printConvergence(bench);
}

}  // namespace stipple
