#include "app/panels/hint_cards.h"

#include <gtest/gtest.h>

#include "tests/app/panels/overlay_picture.h"
#include "tests/app/panels/sample_overlay.h"

namespace stipple {
namespace {

TEST(HintCards, EachIsStartedOrDismissed) {
  for (const float scale : {1.0f, 2.0f}) {
    const std::vector<HintCard> cards = firstCards();
    OverlayStage stage(int(720 * scale), int(140 * scale), {.scale = scale});
    HintActions seen;
    const auto draw = [&] {
      std::vector<PanelPlace> places;
      for (int i = 0; i < 3; ++i)
        places.push_back({{(10 + 234 * i) * scale, 10 * scale}, {224 * scale, 112 * scale}});
      const HintActions actions = drawHintCards(cards, places);
      if (actions.start) seen.start = actions.start;
      if (actions.dismiss) seen.dismiss = actions.dismiss;
    };
    stage.settle(draw);
    for (const HintCard& card : cards) {
      EXPECT_TRUE(stage.clickAround(draw, [&] { return seen.start == card.id; })) << card.id;
      EXPECT_TRUE(stage.clickAround(draw, [&] { return seen.dismiss == card.id; })) << card.id;
    }
  }
}

TEST(HintCards, WithoutAPlaceAreNotDrawn) {
  OverlayStage stage(300, 200);
  const PanelPlace place{{10, 10}, {224, 112}, {}};
  HintActions seen;
  const auto draw = [&] { seen = drawHintCards(firstCards(), {&place, 1}); };
  stage.settle(draw);
  EXPECT_FALSE(stage.clickAround(draw, [&] { return seen.start && seen.start != "segment"; }));
}

}  // namespace
}  // namespace stipple
