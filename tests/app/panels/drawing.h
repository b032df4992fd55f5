#pragma once

#include <imgui.h>

#include <vector>

#include "app/panels/imgui_raster.h"
#include "render/appearance/image.h"

namespace stipple {

/// A picture as a target: rows of its own, nothing beyond them.
PixelTarget targetOf(Image& image, ChannelOrder order = ChannelOrder::kRgba);

Image filledImage(int width, int height, const Rgba8& color);

/// Sum over the pixels of what was covered by white on black, 1 for a whole pixel.
double coveredArea(const Image& image);

/// A drawing made by hand, of a single draw list. Its atlas is 4 x 4 texels: all full but for a checker of
/// 2 x 2 texels in the lower right quarter.
class HandDrawing {
 public:
  static inline const ImVec2 kWhite{0.25f, 0.25f};

  HandDrawing();
  HandDrawing(const HandDrawing&) = delete;
  HandDrawing& operator=(const HandDrawing&) = delete;

  void addTriangle(ImVec2 a, ImVec2 b, ImVec2 c, ImU32 color);
  void addTriangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c);
  /// As Dear ImGui does it: two triangles from the upper left corner on.
  void addRectangle(ImVec2 from, ImVec2 to, ImU32 color, ImVec2 uvFrom = kWhite, ImVec2 uvTo = kWhite);
  /// For what is added afterwards.
  void setScissor(ImVec2 from, ImVec2 to);

  ImDrawData& drawData();
  AlphaTexture atlas() const { return {atlas_, 4, 4}; }
  std::vector<PixelRectangle> draw(Image& image, ChannelOrder order = ChannelOrder::kRgba);

 private:
  void addIndices(std::initializer_list<int> indices);

  std::vector<std::uint8_t> atlas_;
  ImDrawList list_;
  ImDrawList* lists_[1];
  ImDrawData data_;
};

}  // namespace stipple
