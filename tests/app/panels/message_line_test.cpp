#include "app/panels/message_line.h"

#include <gtest/gtest.h>

#include "tests/app/panels/overlay_picture.h"
#include "tests/app/panels/sample_overlay.h"

namespace stipple {
namespace {

constexpr PanelPlace kPlace{{10, 10}, {480, 46}, {0.5f, 1}};

struct Line {
  OverlayStage stage{500, 70};
  MessageModel model;
  MessageActions seen = {};
  std::function<void()> draw = [this] {
    const MessageActions actions = drawMessageLine(model, kPlace);
    seen.showDetails |= actions.showDetails;
    seen.dismiss |= actions.dismiss;
  };
};

TEST(MessageLine, ShowsDetailsAndIsDismissed) {
  Line line{.model = failure()};
  line.stage.settle(line.draw);
  EXPECT_TRUE(line.stage.clickAround(line.draw, [&] { return line.seen.showDetails; }));
  EXPECT_TRUE(line.stage.clickAround(line.draw, [&] { return line.seen.dismiss; }));
}

TEST(MessageLine, HasNoDetailsWhereThereAreNone) {
  MessageModel model = failure();
  model.hasDetails = false;
  Line line{.model = model};
  line.stage.settle(line.draw);
  EXPECT_FALSE(line.stage.clickAround(line.draw, [&] { return line.seen.showDetails; }));
}

TEST(MessageLine, NotesFadeAndErrorsStay) {
  EXPECT_EQ(opacityOf({.text = "saved", .ageSeconds = 1}), 1);
  EXPECT_LT(opacityOf({.text = "saved", .ageSeconds = 5.7f}), 1);
  EXPECT_EQ(opacityOf({.text = "saved", .ageSeconds = 6}), 0);
  EXPECT_EQ(opacityOf({.text = "failed", .kind = MessageKind::kError, .ageSeconds = 1e6f}), 1);
  Line note{.model = {.text = "saved", .ageSeconds = 7}};
  note.stage.settle(note.draw);
  EXPECT_TRUE(note.seen.dismiss);
  Line error{.model = {.text = "failed", .kind = MessageKind::kError, .ageSeconds = 7}};
  error.stage.settle(error.draw);
  EXPECT_FALSE(error.seen.dismiss);
}

TEST(MessageLine, TheMouseHoldsIt) {
  Line note{.model = {.text = "saved", .ageSeconds = 7}};
  note.stage.context().moveMouse({250, 30});
  note.stage.settle(note.draw);
  EXPECT_FALSE(note.seen.dismiss);
}

TEST(MessageLine, CutsWhatIsTooLong) {
  MessageModel model = failure();
  for (int i = 0; i < 5; ++i) model.text += ", and " + model.text;
  Line line{.model = model};
  line.stage.settle(line.draw);
  line.stage.save("message_long");
  EXPECT_TRUE(line.stage.clickAround(line.draw, [&] { return line.seen.dismiss; })) << "still within reach";
}

}  // namespace
}  // namespace stipple
