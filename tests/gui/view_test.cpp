#include <QLabel>
#include <QTabBar>
#include <QTest>

#include "tests/gui/window_test.h"
#include "tests/support/identical.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

class ViewByHand : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    openSphere(3000);
    before_ = points();
    revision_ = scan().document.revision();
  }
  void TearDown() override {
    if (workbench().current() && !workbench().scans().empty()) {
      OpenScan& first = *workbench().scans()[0];
      EXPECT_TRUE(identical(first.document.points(), before_)) << "looking changed the points";
      EXPECT_EQ(first.document.revision(), revision_);
    }
    WindowTest::TearDown();
  }

  QPoint background() { return {6, 6}; }

  PointSet before_;
  std::uint64_t revision_ = 0;
};

TEST_F(ViewByHand, LeftDragTurnsByHalfATurnAPictureHeight) {
  const OrbitCamera camera = scan().camera;
  const int height = view().viewport().widget().height();
  drag({center(), center() + QPoint(height / 4, 0)});
  EXPECT_NEAR(std::abs(scan().camera.yaw() - camera.yaw()), std::numbers::pi / 4, 0.02);
  EXPECT_NEAR(glm::distance(scan().camera.eye(), scan().camera.pivot()),
              glm::distance(camera.eye(), camera.pivot()), 1e-4);
  waitForPicture();
}

TEST_F(ViewByHand, MiddleDragMovesWhatItHolds) {
  const auto held = view().viewport().pickAt({float(center().x()), float(center().y())});
  ASSERT_TRUE(held);
  const QPoint to = center() + QPoint(90, -40);
  drag({center(), to}, {}, Qt::MiddleButton);
  waitForPicture();
  const QSize size = view().viewport().widget().size();
  const View now = scan().camera.view({size.width(), size.height()});
  const glm::vec2 seen = now.toPixels(now.toView(held->position));
  EXPECT_NEAR(seen.x, to.x(), 1.5);
  EXPECT_NEAR(seen.y, to.y(), 1.5);
}

TEST_F(ViewByHand, WheelZoomsTowardTheCursor) {
  const QPoint at = center() + QPoint(70, 30);
  const auto target = view().viewport().pickAt({float(at.x()), float(at.y())});
  ASSERT_TRUE(target);
  const float distance = glm::distance(scan().camera.eye(), target->position);
  turnWheel(at, 3);
  waitForPicture();
  EXPECT_LT(glm::distance(scan().camera.eye(), target->position), 0.9f * distance);
  const QSize size = view().viewport().widget().size();
  const View now = scan().camera.view({size.width(), size.height()});
  const glm::vec2 seen = now.toPixels(now.toView(target->position));
  EXPECT_NEAR(seen.x, at.x(), 1.5);
  EXPECT_NEAR(seen.y, at.y(), 1.5);
}

TEST_F(ViewByHand, DoubleClickSetsThePivotOnTheSurface) {
  const QPoint at = center() + QPoint(60, 0);
  const auto picked = view().viewport().pickAt({float(at.x()), float(at.y())});
  ASSERT_TRUE(picked);
  QTest::mouseDClick(window().windowHandle(), Qt::LeftButton, {},
                     view().viewport().widget().mapTo(&window(), at));
  EXPECT_LT(glm::distance(scan().camera.pivot(), picked->position), 1e-3);
  moveTo(background());
}

TEST_F(ViewByHand, KeysShowTheSidesAndFrame) {
  const auto direction = [this] { return glm::normalize(scan().camera.eye() - scan().camera.pivot()); };
  key(Qt::Key_7);
  EXPECT_NEAR(direction().z, 1, 1e-3) << "from above";
  key(Qt::Key_7, Qt::ControlModifier);
  EXPECT_NEAR(direction().z, -1, 1e-3);
  key(Qt::Key_1);
  EXPECT_NEAR(direction().y, -1, 1e-3) << "from the front";
  key(Qt::Key_3);
  EXPECT_NEAR(direction().x, 1, 1e-3) << "from the right";
  const OrbitCamera framed = scan().camera;
  key(Qt::Key_5);
  EXPECT_EQ(scan().camera.projection(), Projection::kOrthographic);
  key(Qt::Key_5);
  EXPECT_EQ(scan().camera.projection(), Projection::kPerspective);
  turnWheel(center(), 4);
  drag({center(), center() + QPoint(50, 0)}, {}, Qt::MiddleButton);
  EXPECT_GT(glm::distance(scan().camera.eye(), framed.eye()), 0.1);
  key(Qt::Key_Home);
  EXPECT_LT(glm::distance(scan().camera.eye(), framed.eye()), 1e-3);
  waitForPicture();
}

TEST_F(ViewByHand, TabFoldsThePanelsAndBack) {
  const int width = view().viewport().widget().width();
  view().viewport().widget().setFocus();
  key(Qt::Key_Tab);
  waitFor("a wider view", [&] { return view().viewport().widget().width() > width + 100; });
  waitForPicture();
  key(Qt::Key_Tab);
  waitFor("the panels", [&] { return view().viewport().widget().width() == width; });
}

TEST_F(ViewByHand, SeveralScansInTabsKeepTheirViews) {
  auto* tabs = window().findChild<QTabBar*>();
  EXPECT_FALSE(tabs->isVisible()) << "one scan needs no tabs";
  key(Qt::Key_7);
  open(writeSphere("other.ply", 500));
  EXPECT_TRUE(tabs->isVisible());
  ASSERT_EQ(tabs->count(), 2);
  EXPECT_EQ(tabs->currentIndex(), 1);
  EXPECT_EQ(tabs->tabText(0), "sphere.ply");
  EXPECT_EQ(tabs->tabText(1), "other.ply");
  workbench().flipNormals();
  EXPECT_EQ(tabs->tabText(1), "other.ply *");
  EXPECT_EQ(find<QLabel>("points")->text(), "500 points");
  QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(0).center());
  EXPECT_EQ(workbench().currentIndex(), 0);
  EXPECT_EQ(find<QLabel>("points")->text(), "3,000 points");
  EXPECT_THAT(window().windowTitle().toStdString(), HasSubstr("sphere.ply"));
  EXPECT_FALSE(window().isWindowModified());
  EXPECT_NEAR(glm::normalize(scan().camera.eye()).z, 1, 1e-3) << "the other's camera";
  // Undo is each scan's own.
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(workbench().scans()[1]->document.isModified());
  key(Qt::Key_W, Qt::ControlModifier);
  ASSERT_THAT(workbench().scans(), SizeIs(1));
  EXPECT_EQ(points().size(), 500u);
  before_ = points();
  revision_ = scan().document.revision();
}

TEST_F(ViewByHand, MeasuringAndInspectingChangeNothing) {
  choose("tool_inspect");
  press(center());
  release(center());
  choose("tool_measure");
  for (const QPoint& at : {center(), center() + QPoint(80, 0)}) {
    press(at);
    release(at);
  }
  waitUntilIdle();
  waitForPicture();
  key(Qt::Key_Escape);
  EXPECT_TRUE(said_.empty()) << said_.front().toStdString();
}

}  // namespace
}  // namespace stipple
