#include "tests/support/popping.h"

#include <fmt/format.h>

#include "tests/bench/render/workbench.h"

namespace stipple {

void printPopping(Workbench& bench) {
  const Hierarchy& hierarchy = bench.hierarchy();
  fmt::print("change from frame to frame beyond that of the surface, mean of 255; 120 frames of 240 x 136\n");
  for (const float lastZoom : {2.f, 6.f}) {
    for (const float tau : {4.f, 8.f}) {
      const ZoomPath path{
          .start = {.yaw = 0.3f, .pitch = 0.67f}, .lastZoom = lastZoom, .width = 240, .height = 136};
      const Popping p = measurePopping(bench.renderer, hierarchy, bench.torus.surface, path, {.tau = tau});
      fmt::print(
          "zoom 1 to {} tau {}: worst {:+.3f} (frame {}), worst tile {:+.2f}; motion itself {:.2f}; "
          "incomplete {}, holes {}\n",
          lastZoom, tau, p.worst, p.worstFrame, p.worstTile, p.motion, p.incompleteFrames, p.holes);
      std::fflush(stdout);
    }
  }
}

}  // namespace stipple
