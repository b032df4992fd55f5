#include "app/panels/icons.h"

#include <gtest/gtest.h>

#include "tests/app/panels/overlay_picture.h"

namespace stipple {
namespace {

constexpr Icon kIcons[] = {Icon::kPaint,   Icon::kErase,   Icon::kSmooth, Icon::kSelect, Icon::kPlay,
                           Icon::kPause,   Icon::kStep,    Icon::kStop,   Icon::kClose,  Icon::kAdd,
                           Icon::kChevron, Icon::kWarning, Icon::kNote};

TEST(Icons, FillTheirSquareAndNothingElse) {
  for (const float size : {14.0f, 32.0f}) {
    for (const Icon icon : kIcons) {
      OverlayStage stage(64, 64);
      stage.frame([] {});
      const Image empty = stage.picture();
      stage.frame([&] {
        drawIcon(*ImGui::GetForegroundDrawList(), icon, ImVec2(32, 32), size, IM_COL32(255, 0, 255, 255));
      });
      const Image image = stage.picture();
      int changed = 0;
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
          if (image.at(x, y) == empty.at(x, y)) continue;
          ++changed;
          EXPECT_LE(std::abs(x + 0.5f - 32), size / 2 + 1) << int(icon);
          EXPECT_LE(std::abs(y + 0.5f - 32), size / 2 + 1) << int(icon);
        }
      }
      EXPECT_GT(changed, 0.08f * size * size) << int(icon);
      EXPECT_LT(changed, 0.85f * size * size) << int(icon);
    }
  }
}

TEST(Icons, AreSeen) {
  for (const float scale : {1.0f, 2.0f}) {
    OverlayStage stage(int(480 * scale), int(60 * scale), {.scale = scale});
    stage.settle([&] {
      float x = 30 * scale;
      for (const Icon icon : kIcons) {
        drawIcon(*ImGui::GetForegroundDrawList(), icon, ImVec2(x, 30 * scale), 18 * scale,
                 IM_COL32(230, 230, 230, 255));
        x += 34 * scale;
      }
    });
    stage.save(scale == 1 ? "icons_1" : "icons_2");
  }
}

}  // namespace
}  // namespace stipple
