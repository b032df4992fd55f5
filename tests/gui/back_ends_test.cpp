#include <QPushButton>

#include "tests/gui/window_test.h"
#include "tests/support/identical.h"

namespace stipple {
namespace {

/// What an artist does first, with each back end.
class BackEnds : public WindowTest, public testing::WithParamInterface<ViewportKind> {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    startWindow(GetParam());
  }
};

TEST_P(BackEnds, OpenLookPaintRunAndUndo) {
  ASSERT_STREQ(view().viewport().backend(), GetParam() == ViewportKind::kGl ? "gl" : "cpu");
  openSphere();
  const PointSet before = points();
  const auto picked = view().viewport().pickAt({float(center().x()), float(center().y())});
  ASSERT_TRUE(picked);
  EXPECT_NEAR(glm::length(picked->position), 1, 0.02);
  drag({center(), center() + QPoint(60, 20)});
  turnWheel(center(), 1);
  waitForPicture();

  chooseOperator("segmentation");
  click(*find<QPushButton>("paint_seeds"));
  waitFor("the brush", [this] { return scan().hasDistance(); });
  for (int x = -40; x <= 40; x += 4) moveTo(center() + QPoint(x, 0));
  const auto color = [this] {
    return view().viewport().widget().grab().toImage().pixelColor(center() + QPoint(0, 14));
  };
  const QColor bare = color();
  drag({center() + QPoint(-30, 0), center() + QPoint(30, 0)});
  ASSERT_TRUE(points().has("seeds"));
  waitFor("paint in the picture", [&] { return color() != bare; });
  const PointSet painted = points();
  click(*find<QPushButton>("run"));
  waitUntilIdle();
  ASSERT_TRUE(points().has("segment"));
  waitForPicture();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(identical(points(), painted));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(identical(points(), before));
  EXPECT_TRUE(said_.empty()) << said_.front().toStdString();
}

TEST_P(BackEnds, ResizesClosesAndOpensAgain) {
  openSphere(2000);
  window().setWindowState(Qt::WindowNoState);
  window().resize(800, 560);
  waitForPicture();
  key(Qt::Key_W, Qt::ControlModifier);
  EXPECT_TRUE(workbench().scans().empty());
  openSphere(3000);
  EXPECT_TRUE(view().viewport().pickAt({float(center().x()), float(center().y())}));
  const Image picture = view().viewport().picture();
  EXPECT_EQ(picture.width, view().viewport().widget().width());
  EXPECT_EQ(picture.height, view().viewport().widget().height());
}

INSTANTIATE_TEST_SUITE_P(All, BackEnds, testing::Values(ViewportKind::kCpu, ViewportKind::kGl),
                         [](const auto& chosen) { return chosen.param == ViewportKind::kGl ? "gl" : "cpu"; });

}  // namespace
}  // namespace stipple
