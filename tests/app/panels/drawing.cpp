#include "tests/app/panels/drawing.h"

namespace stipple {

PixelTarget targetOf(Image& image, ChannelOrder order) {
  static_assert(sizeof(Rgba8) == sizeof(std::uint32_t));
  return {.pixels = {reinterpret_cast<std::uint32_t*>(image.pixels.data()), image.pixels.size()},
          .width = image.width,
          .height = image.height,
          .stride = static_cast<std::size_t>(image.width),
          .order = order};
}

Image filledImage(int width, int height, const Rgba8& color) {
  return {width, height, std::vector<Rgba8>(static_cast<std::size_t>(width) * height, color)};
}

double coveredArea(const Image& image) {
  double sum = 0;
  for (const Rgba8& pixel : image.pixels) sum += pixel.r / 255.0;
  return sum;
}

HandDrawing::HandDrawing() : atlas_(16, 255), list_(nullptr), lists_{&list_} {
  atlas_[2 * 4 + 3] = atlas_[3 * 4 + 2] = 0;
  data_.FramebufferScale = ImVec2(1, 1);
  setScissor(ImVec2(-1e6f, -1e6f), ImVec2(1e6f, 1e6f));
}

void HandDrawing::setScissor(ImVec2 from, ImVec2 to) {
  ImDrawCmd command;
  command.ClipRect = ImVec4(from.x, from.y, to.x, to.y);
  command.IdxOffset = static_cast<unsigned>(list_.IdxBuffer.Size);
  list_.CmdBuffer.push_back(command);
}

void HandDrawing::addIndices(std::initializer_list<int> indices) {
  for (const int index : indices) list_.IdxBuffer.push_back(static_cast<ImDrawIdx>(index));
  list_.CmdBuffer.back().ElemCount += static_cast<unsigned>(indices.size());
}

void HandDrawing::addTriangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c) {
  const int first = list_.VtxBuffer.Size;
  for (const ImDrawVert& vertex : {a, b, c}) list_.VtxBuffer.push_back(vertex);
  addIndices({first, first + 1, first + 2});
}

void HandDrawing::addTriangle(ImVec2 a, ImVec2 b, ImVec2 c, ImU32 color) {
  addTriangle({a, kWhite, color}, {b, kWhite, color}, {c, kWhite, color});
}

void HandDrawing::addRectangle(ImVec2 from, ImVec2 to, ImU32 color, ImVec2 uvFrom, ImVec2 uvTo) {
  const int first = list_.VtxBuffer.Size;
  list_.VtxBuffer.push_back({from, uvFrom, color});
  list_.VtxBuffer.push_back({ImVec2(to.x, from.y), ImVec2(uvTo.x, uvFrom.y), color});
  list_.VtxBuffer.push_back({to, uvTo, color});
  list_.VtxBuffer.push_back({ImVec2(from.x, to.y), ImVec2(uvFrom.x, uvTo.y), color});
  addIndices({first, first + 1, first + 2, first, first + 2, first + 3});
}

ImDrawData& HandDrawing::drawData() {
  data_.Valid = true;
  data_.CmdLists = lists_;
  data_.CmdListsCount = 1;
  data_.TotalVtxCount = list_.VtxBuffer.Size;
  data_.TotalIdxCount = list_.IdxBuffer.Size;
  return data_;
}

std::vector<PixelRectangle> HandDrawing::draw(Image& image, ChannelOrder order) {
  return rasterize(drawData(), atlas(), targetOf(image, order));
}

}  // namespace stipple
