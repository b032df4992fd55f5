#include "app/panels/overlay_layout.h"

#include <gtest/gtest.h>

namespace stipple {
namespace {

bool overlap(const PanelPlace& a, const PanelPlace& b) {
  return a.position.x < b.position.x + b.size.x && b.position.x < a.position.x + a.size.x &&
         a.position.y < b.position.y + b.size.y && b.position.y < a.position.y + a.size.y;
}

std::vector<PanelPlace> allOf(const OverlayLayout& layout) {
  std::vector<PanelPlace> places = {layout.brush, layout.curve, layout.statistics, layout.legend,
                                    layout.message};
  places.insert(places.end(), layout.cards.begin(), layout.cards.end());
  return places;
}

TEST(OverlayLayout, PlacesLieInTheViewAndApart) {
  for (const float scale : {1.0f, 1.25f, 1.5f, 2.0f}) {
    for (const glm::vec2 size : {glm::vec2(1280, 800), {1280, 720}, {940, 640}, {760, 560}, {2560, 1440}}) {
      for (const std::size_t cards : {0, 1, 2, 3}) {
        const glm::vec2 view = size * scale;
        const OverlayLayout layout = layOut(view, scale,
                                            {.brush = true,
                                             .curve = true,
                                             .statistics = true,
                                             .legend = true,
                                             .message = true,
                                             .cards = cards});
        const std::vector<PanelPlace> places = allOf(layout);
        for (std::size_t i = 0; i < places.size(); ++i) {
          EXPECT_GE(places[i].position.x, 0);
          EXPECT_GE(places[i].position.y, 0);
          EXPECT_LE(places[i].position.x + places[i].size.x, view.x);
          EXPECT_LE(places[i].position.y + places[i].size.y, view.y);
          for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(places[i], places[j])) << i << ' ' << j;
        }
      }
    }
  }
}

TEST(OverlayLayout, WhatIsHiddenLeavesItsRoom) {
  const OverlayLayout with = layOut({1280, 800}, 1, {.brush = true, .curve = true});
  const OverlayLayout without = layOut({1280, 800}, 1, {.brush = true});
  EXPECT_GT(without.brush.size.y, with.brush.size.y);
  EXPECT_GT(layOut({700, 600}, 1, {.cards = 3}).cards[0].position.y,
            layOut({700, 600}, 1, {.brush = true, .cards = 3}).cards[0].position.y)
      << "fewer rows";
}

TEST(OverlayLayout, CardsStandSideBySideWhereTheyFit) {
  const auto wide = layOut({1280, 800}, 1, {.brush = true, .legend = true, .cards = 3}).cards;
  ASSERT_EQ(wide.size(), 3u);
  EXPECT_EQ(wide[0].position.y, wide[2].position.y);
  const auto narrow = layOut({800, 800}, 1, {.brush = true, .legend = true, .cards = 3}).cards;
  ASSERT_EQ(narrow.size(), 3u);
  EXPECT_EQ(narrow[0].position.x, narrow[2].position.x);
}

TEST(OverlayLayout, OfATinyViewHoldsWhatFits) {
  const OverlayLayout layout =
      layOut({100, 50}, 1, {.brush = true, .curve = true, .statistics = true, .legend = true, .cards = 3});
  EXPECT_TRUE(layout.cards.empty());
  for (const PanelPlace& place : allOf(layout)) {
    EXPECT_GE(place.size.x, 0);
    EXPECT_GE(place.size.y, 0);
  }
}

}  // namespace
}  // namespace stipple
