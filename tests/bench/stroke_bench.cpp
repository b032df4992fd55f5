#include <benchmark/benchmark.h>

#include "app/document/document.h"
#include "app/document/stroke_painter.h"
#include "tests/support/shapes.h"

// Dabs on a sphere of a million points, each of which reaches about 20 000 of them.

namespace stipple {
namespace {

constexpr float kRadius = 0.284f;  // 2 % of the unit sphere

struct Scan {
  PointSet points;
  std::shared_ptr<const SurfaceDistance> surface;
};

const Scan& scan() {
  static const Scan kScan = [] {
    PointSet points(shapes::randomSphere(1'000'000));
    points.set("color", std::vector<Rgba8>(points.size()));
    points.set("label", std::vector<std::int32_t>(points.size()));
    return Scan{points, std::make_shared<SurfaceDistance>(points)};
  }();
  return kScan;
}

void findWithin(benchmark::State& state) {
  const auto& surface = *scan().surface;
  std::size_t reached = 0;
  Index start = 0;
  for (auto _ : state) {
    reached = surface.findWithin(start, kRadius).size();
    start = (start + 7919) % surface.sites().size();
  }
  state.counters["points"] = static_cast<double>(reached);
}
BENCHMARK(findWithin)->Unit(benchmark::kMillisecond);

void layDabs(benchmark::State& state, const Stroke& stroke) {
  Document document(scan().points, {});
  const StrokePainter painter(scan().surface, stroke);
  document.beginStroke("Paint");
  Index row = 0;
  for (auto _ : state) {
    const Dab dab{.position = document.points().positions()[row].cast<double>()};
    document.paint([&](PointSet& points) { return painter.lay(points, dab); });
    row = (row + 7919) % document.points().size();
  }
  document.endStroke({});
}
BENCHMARK_CAPTURE(layDabs, paint color, {.attribute = "color", .value = {9, 8, 7}, .radius = kRadius})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(layDabs, paint label, {.attribute = "label", .value = {3}, .radius = kRadius})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(layDabs, smooth color,
                  {.tool = StrokeTool::kSmooth, .attribute = "color", .value = {}, .radius = kRadius})
    ->Unit(benchmark::kMillisecond);

void endStroke(benchmark::State& state) {
  Document document(scan().points, {});
  const StrokePainter painter(scan().surface, {.attribute = "label", .value = {3}, .radius = kRadius});
  for (auto _ : state) {
    state.PauseTiming();
    document.beginStroke("Paint");
    document.paint([&](PointSet& points) { return painter.lay(points, {.position = {1, 0, 0}}); });
    state.ResumeTiming();
    document.endStroke({});
    state.PauseTiming();
    document.undo();
    state.ResumeTiming();
  }
}
BENCHMARK(endStroke)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stipple
