#include "tests/app/panels/overlay_picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/panels/imgui_raster.h"
#include "render/appearance/png.h"
#include "tests/app/panels/drawing.h"

namespace stipple {

namespace {

// A lit ball before the viewport's background, so that panels are seen over light and dark.
Image makeGround(int width, int height) {
  Image image = filledImage(width, height, {43, 43, 46, 255});
  const double radius = 0.46 * std::min(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x - 0.5 * width) / (1.35 * radius), v = (y - 0.5 * height) / radius;
      if (u * u + v * v > 1) continue;
      const double light =
          0.25 + 0.7 * std::max(0.0, -0.35 * u - 0.45 * v + 0.8 * std::sqrt(1 - u * u - v * v));
      const auto shade = [&](double channel) {
        return static_cast<std::uint8_t>(std::clamp(channel * light, 0.0, 255.0));
      };
      image.at(x, y) = {shade(205), shade(190), shade(170), 255};
    }
  }
  return image;
}

}  // namespace

OverlayStage::OverlayStage(int width, int height, const OverlayLook& look)
    : context_(look), size_(width, height) {}

void OverlayStage::frame(const std::function<void()>& drawPanels) {
  context_.beginFrame(size_, 1.0f / 60);
  drawPanels();
  drawing_ = &context_.endFrame();
}

void OverlayStage::settle(const std::function<void()>& drawPanels) {
  for (int i = 0; i < 4; ++i) frame(drawPanels);
}

void OverlayStage::click(glm::vec2 position, const std::function<void()>& drawPanels) {
  drag(position, position, drawPanels);
}

void OverlayStage::drag(glm::vec2 from, glm::vec2 to, const std::function<void()>& drawPanels) {
  context_.moveMouse(from);
  frame(drawPanels);
  context_.setButton(OverlayButton::kLeft, true);
  frame(drawPanels);
  constexpr int kSteps = 5;
  for (int i = 1; from != to && i <= kSteps; ++i) {
    context_.moveMouse(from + (to - from) * (float(i) / kSteps));
    frame(drawPanels);
  }
  context_.setButton(OverlayButton::kLeft, false);
  frame(drawPanels);
  frame(drawPanels);
}

bool OverlayStage::clickAround(const std::function<void()>& drawPanels, const std::function<bool()>& isDone) {
  const float step = 9 * context_.look().scale;
  for (float y = step; y < float(size_.y); y += step) {
    for (float x = step; x < float(size_.x); x += step) {
      context_.moveMouse({x, y});
      if (!context_.wantsMouse()) continue;
      click({x, y}, drawPanels);
      if (isDone()) return true;
      if (context_.wantsKeyboard()) context_.setKey(OverlayKey::kEscape, true);
      frame(drawPanels);
      context_.setKey(OverlayKey::kEscape, false);
      frame(drawPanels);
    }
  }
  return false;
}

Image OverlayStage::picture() {
  Image image = makeGround(size_.x, size_.y);
  rasterize(*drawing_, context_.atlas(), targetOf(image));
  return image;
}

void OverlayStage::save(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(STIPPLE_BINARY_DIR) / "tests" / "overlay";
  std::filesystem::create_directories(folder);
  writePng(folder / (name + ".png"), picture());
}

}  // namespace stipple
