#include <benchmark/benchmark.h>
#include <imgui.h>

#include "app/panels/imgui_raster.h"
#include "app/panels/overlay_context.h"
#include "tests/app/panels/drawing.h"
#include "tests/app/panels/sample_overlay.h"

namespace stipple {
namespace {

// Four panels at work, as they stand beside a running process.
OverlayModel workingOverlay() {
  OverlayModel model = fullOverlay();
  model.cards.clear();
  model.message.reset();
  return model;
}

struct Screen {
  int width, height;
  float scale;
};
constexpr Screen kScreens[] = {{1600, 1000, 1}, {3200, 2000, 2}};

const ImDrawData& drawSettled(OverlayContext& context, const Screen& screen, const OverlayModel& model) {
  const ImDrawData* drawing = nullptr;
  for (int i = 0; i < 4; ++i) {
    context.beginFrame({screen.width, screen.height}, 1.0f / 60);
    drawOverlay(model);
    drawing = &context.endFrame();
  }
  return *drawing;
}

void rasterizeOverlay(benchmark::State& state) {
  const Screen screen = kScreens[state.range(0)];
  OverlayContext context({.scale = screen.scale});
  const ImDrawData& drawing = drawSettled(context, screen, workingOverlay());
  Image image = filledImage(screen.width, screen.height, {90, 90, 90, 255});
  double pixels = 0;
  for (auto _ : state) {
    pixels = 0;
    for (const PixelRectangle& touched :
         rasterize(drawing, context.atlas(), targetOf(image, ChannelOrder::kBgra))) {
      pixels += double(touched.width()) * touched.height();
    }
  }
  state.counters["triangles"] = drawing.TotalIdxCount / 3;
  state.counters["pixels"] = pixels;
}
BENCHMARK(rasterizeOverlay)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void buildOverlay(benchmark::State& state) {
  const Screen screen = kScreens[state.range(0)];
  OverlayContext context({.scale = screen.scale});
  const OverlayModel model = workingOverlay();
  for (auto _ : state) {
    context.beginFrame({screen.width, screen.height}, 1.0f / 60);
    drawOverlay(model);
    benchmark::DoNotOptimize(&context.endFrame());
  }
}
BENCHMARK(buildOverlay)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void fingerprintOverlay(benchmark::State& state) {
  OverlayContext context;
  const ImDrawData& drawing = drawSettled(context, kScreens[0], workingOverlay());
  for (auto _ : state) benchmark::DoNotOptimize(fingerprintOf(drawing));
}
BENCHMARK(fingerprintOverlay)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stipple
