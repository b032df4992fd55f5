#include "app/panels/imgui_raster.h"

#include <gmock/gmock.h>

#include "tests/app/panels/drawing.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr Rgba8 kBlack{0, 0, 0, 255};
constexpr ImU32 kWhite = IM_COL32_WHITE;

TEST(Rasterize, BlendsWithKnownAnswers) {
  Image image = filledImage(4, 4, {100, 100, 100, 255});
  HandDrawing drawing;
  drawing.addRectangle({0, 0}, {2, 4}, IM_COL32(200, 0, 50, 51));  // a fifth
  drawing.draw(image);
  EXPECT_EQ(image.at(0, 0), (Rgba8{120, 80, 90, 255}));
  EXPECT_EQ(image.at(3, 0), (Rgba8{100, 100, 100, 255}));
}

TEST(Rasterize, KnowsBothOrdersOfChannels) {
  Image image = filledImage(2, 1, kBlack);
  HandDrawing drawing;
  drawing.addRectangle({0, 0}, {2, 1}, IM_COL32(255, 128, 7, 255));
  drawing.draw(image, ChannelOrder::kBgra);
  EXPECT_EQ(image.at(0, 0), (Rgba8{7, 128, 255, 255}));
  drawing.draw(image, ChannelOrder::kRgba);
  EXPECT_EQ(image.at(0, 0), (Rgba8{255, 128, 7, 255}));
}

TEST(Rasterize, StaysWithinTheScissorAndThePicture) {
  Image image = filledImage(20, 20, kBlack);
  HandDrawing drawing;
  drawing.setScissor({5, 6}, {9, 11});
  drawing.addRectangle({-100, -100}, {100, 100}, kWhite);
  drawing.setScissor({15, 15}, {1000, 1000});
  drawing.addTriangle({0, 0}, {1000, 0}, {0, 1000}, kWhite);
  const auto touched = drawing.draw(image);
  EXPECT_EQ(coveredArea(image), 4 * 5 + 5 * 5);
  EXPECT_THAT(touched, UnorderedElementsAre(PixelRectangle{5, 6, 9, 11}, PixelRectangle{15, 15, 20, 20}));
}

TEST(Rasterize, LeavesWhatLiesBetweenTheRowsAlone) {
  std::vector<std::uint32_t> pixels(10 * 5, 0xff000000u);
  HandDrawing drawing;
  drawing.addRectangle({0, 0}, {100, 100}, kWhite);
  rasterize(drawing.drawData(), drawing.atlas(), {.pixels = pixels, .width = 7, .height = 5, .stride = 10});
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_EQ(pixels[i], i % 10 < 7 ? 0xffffffffu : 0xff000000u);
  }
}

TEST(Rasterize, FollowsTheDisplaysPlaceAndScale) {
  Image image = filledImage(40, 40, kBlack);
  HandDrawing drawing;
  drawing.setScissor({100, 100}, {110, 104});
  drawing.addRectangle({102, 101}, {120, 120}, kWhite);
  drawing.drawData().DisplayPos = ImVec2(100, 100);
  drawing.drawData().FramebufferScale = ImVec2(2, 2);
  const auto touched = rasterize(drawing.drawData(), drawing.atlas(), targetOf(image));
  EXPECT_THAT(touched, ElementsAre(PixelRectangle{4, 2, 20, 8}));
  EXPECT_EQ(coveredArea(image), 16 * 6);
}

TEST(Rasterize, TellsDisjointRectanglesThatHoldAllItTouched) {
  Image image = filledImage(100, 100, kBlack);
  HandDrawing drawing;
  const ImVec2 sizes(10, 10);
  for (const ImVec2 from : {ImVec2(5, 5), ImVec2(50, 50), ImVec2(12, 12), ImVec2(80, 5), ImVec2(18, 8)}) {
    drawing.setScissor({0, 0}, {100, 100});
    drawing.addRectangle(from, {from.x + sizes.x, from.y + sizes.y}, kWhite);
  }
  const auto touched = drawing.draw(image);
  EXPECT_THAT(touched, UnorderedElementsAre(PixelRectangle{5, 5, 28, 22}, PixelRectangle{50, 50, 60, 60},
                                            PixelRectangle{80, 5, 90, 15}));
}

TEST(Rasterize, ADrawingOfNothingTouchesNothing) {
  Image image = filledImage(8, 8, kBlack);
  HandDrawing drawing;
  EXPECT_THAT(drawing.draw(image), IsEmpty());
  drawing.setScissor({5, 5}, {5, 5});
  drawing.addRectangle({0, 0}, {8, 8}, kWhite);
  drawing.setScissor({-9, -9}, {-1, -1});
  drawing.addRectangle({-9, -9}, {8, 8}, kWhite);
  EXPECT_THAT(drawing.draw(image), IsEmpty());
  EXPECT_EQ(coveredArea(image), 0);
}

TEST(Fingerprint, IsThatOfTheDrawing) {
  const auto fingerprint = [](ImVec2 to, ImU32 color, float scissor) {
    HandDrawing drawing;
    drawing.setScissor({0, 0}, {scissor, scissor});
    drawing.addRectangle({0, 0}, to, color);
    return fingerprintOf(drawing.drawData());
  };
  const std::uint64_t first = fingerprint({8, 8}, kWhite, 100);
  EXPECT_EQ(fingerprint({8, 8}, kWhite, 100), first);
  EXPECT_NE(fingerprint({8, 9}, kWhite, 100), first);
  EXPECT_NE(fingerprint({8, 8}, IM_COL32(255, 255, 254, 255), 100), first);
  EXPECT_NE(fingerprint({8, 8}, kWhite, 99), first);
}

}  // namespace
}  // namespace stipple
