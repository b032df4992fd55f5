#include <QApplication>
#include <QListWidget>
#include <QPushButton>
#include <optional>
#include <set>

#include "render/appearance/colormap.h"
#include "tests/gui/window_test.h"
#include "tests/support/identical.h"

namespace stipple {
namespace {

using testing::Each;
using testing::SizeIs;

constexpr int kRadius = 40;  // pixels, the brush's first size

class Painting : public WindowTest {
 protected:
  /// The brush of the segmentation, and a sphere.
  void takeSeedBrush(Index count = 6000) {
    openSphere(count);
    chooseOperator("segmentation");
    click(*find<QPushButton>("paint_seeds"));
    waitFor("the brush", [this] { return scan().hasDistance(); });
    waitForPicture();
  }

  std::vector<QPoint> stroke() { return {center() + QPoint(-60, 20), center() + QPoint(60, -20)}; }

  // Where the panel in the left half of the view offers a label.
  std::optional<QPoint> swatchOf(int label) {
    const QImage image = view().viewport().widget().grab().toImage();
    const Rgba8 color = labelColor(label);
    const QRgb wanted = qRgb(color.r, color.g, color.b);
    for (int y = 0; y + 6 < image.height(); ++y) {
      for (int x = 0; x + 6 < image.width() / 2; ++x) {
        if (image.pixel(x, y) == wanted && image.pixel(x + 5, y + 5) == wanted) return QPoint(x + 3, y + 3);
      }
    }
    return {};
  }

  // Before the window has drawn anything.
  void sendAtOnce(QEvent::Type type, const QPoint& at) {
    const bool isMove = type == QEvent::MouseMove, isRelease = type == QEvent::MouseButtonRelease;
    QWidget& widget = view().viewport().widget();
    QMouseEvent event(type, at, widget.mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                      isRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
  }

  float distanceTo(Index row, const std::vector<QPoint>& path) {
    const glm::vec2 p = pixelOf(row), a(path[0].x(), path[0].y()), b(path[1].x(), path[1].y());
    const float along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0f, 1.0f);
    return glm::distance(p, a + along * (b - a));
  }

  bool facesTheEye(Index row) {
    const Eigen::Vector3f& p = points().positions()[row];
    const glm::vec3 normal(p.x(), p.y(), p.z());
    return glm::dot(scan().camera.eye() - normal, normal) > 0;
  }
};

TEST_F(Painting, LaysSeedsUnderTheMouseAndNowhereElse) {
  takeSeedBrush(60000);
  drag(stroke());
  ASSERT_TRUE(points().has("seeds"));
  const auto seeds = points().values<std::int32_t>("seeds");
  EXPECT_EQ(std::set<int>(seeds.begin(), seeds.end()), (std::set<int>{0, 1}));
  for (Index row = 0; row < points().size(); ++row) {
    const float distance = distanceTo(row, stroke());
    // Points lie about five pixels apart, paths from one to the next are up to a tenth longer than straight
    // lines, and the surface leans away by up to a twentieth.
    if (seeds[row] != 0) {
      EXPECT_TRUE(facesTheEye(row) && distance < 1.15f * kRadius) << distance;
    } else if (facesTheEye(row)) {
      EXPECT_GT(distance, 0.65f * kRadius);
    }
  }
  EXPECT_EQ(scan().document.history().size(), 1u);
  EXPECT_EQ(history().count(), 2);
  EXPECT_TRUE(scan().document.isModified());
  EXPECT_TRUE(window().isWindowModified());
}

TEST_F(Painting, ALabelThatWasClickedIsPaintedThoughNoPictureCameBetween) {
  takeSeedBrush();
  std::optional<QPoint> second;
  waitFor("the label", [&] { return (second = swatchOf(2)).has_value(); });
  sendAtOnce(QEvent::MouseButtonPress, *second);
  sendAtOnce(QEvent::MouseButtonRelease, *second);
  sendAtOnce(QEvent::MouseButtonPress, stroke()[0]);
  sendAtOnce(QEvent::MouseMove, stroke()[1]);
  sendAtOnce(QEvent::MouseButtonRelease, stroke()[1]);
  ASSERT_TRUE(points().has("seeds"));
  const auto seeds = points().values<std::int32_t>("seeds");
  EXPECT_EQ(std::set<int>(seeds.begin(), seeds.end()), (std::set<int>{0, 2}));
}

TEST_F(Painting, ThePanelOfTheBrushComesWithoutTheMouse) {
  takeSeedBrush();
  view().setTool(Tool::kOrbit);
  waitForPicture();
  waitFor("no panel", [this] { return !swatchOf(2); });
  view().setTool(Tool::kPaint);
  EXPECT_TRUE(waitFor(
      "the panel", [this] { return swatchOf(2).has_value(); }, 10'000));
}

TEST_F(Painting, WhatIsPaintedIsShown) {
  takeSeedBrush();
  scan().look.colors = ColorSource{.attribute = "altitude"};
  view().relook();
  drag(stroke());
  EXPECT_EQ(scan().look.colors.attribute, "seeds");
}

TEST_F(Painting, IsSeenAtOnce) {
  takeSeedBrush();
  const auto color = [this] {
    return view().viewport().widget().grab().toImage().pixelColor(center() + QPoint(0, 12));
  };
  const QColor before = color();
  press(center() + QPoint(-30, 0));
  moveTo(center() + QPoint(0, 0));
  moveTo(center() + QPoint(30, 0));
  waitFor("another color under the brush", [&] { return color() != before; });
  release(center() + QPoint(30, 0));
}

TEST_F(Painting, EscapeRestoresBitForBit) {
  takeSeedBrush();
  drag(stroke());
  const PointSet before = points();
  const std::size_t entries = scan().document.history().size();
  press(center() + QPoint(0, -90));
  moveTo(center() + QPoint(20, -80));
  moveTo(center() + QPoint(40, -70));
  ASSERT_TRUE(scan().document.isInStroke());
  ASSERT_FALSE(identical(points(), before)) << "the stroke had not begun";
  key(Qt::Key_Escape);
  EXPECT_FALSE(scan().document.isInStroke());
  EXPECT_TRUE(identical(points(), before));
  moveTo(center() + QPoint(60, -60));
  release(center() + QPoint(60, -60));
  EXPECT_TRUE(identical(points(), before)) << "the rest of the drag painted";
  EXPECT_EQ(scan().document.history().size(), entries);
  EXPECT_EQ(history().count(), 2);
}

TEST_F(Painting, UndoRedoAndTheHistoryListAreExact) {
  takeSeedBrush();
  std::vector<PointSet> states{points()};
  for (int i = 0; i < 3; ++i) {
    const QPoint at = center() + QPoint(-80 + 80 * i, -60 + 50 * i);
    drag({at, at + QPoint(30, 0)});
    states.push_back(points());
    ASSERT_FALSE(identical(states[i], states[i + 1]));
  }
  ASSERT_EQ(history().count(), 4);
  const auto expectState = [&](std::size_t at) {
    EXPECT_TRUE(identical(points(), states[at])) << at;
    EXPECT_EQ(history().currentRow(), static_cast<int>(at));
    EXPECT_EQ(scan().document.isModified(), at != 0);
    EXPECT_EQ(window().isWindowModified(), at != 0);
  };
  for (const std::size_t at : {2, 1, 0}) {
    key(Qt::Key_Z, Qt::ControlModifier);
    expectState(at);
  }
  key(Qt::Key_Z, Qt::ControlModifier);
  expectState(0);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  expectState(1);
  for (const int row : {3, 0, 2, 3, 1}) {
    clickHistory(row);
    expectState(static_cast<std::size_t>(row));
  }
  // Something else is done: what was undone goes.
  drag({center() + QPoint(0, 80), center() + QPoint(20, 80)});
  EXPECT_EQ(history().count(), 3);
  EXPECT_EQ(scan().document.history().size(), 2u);
}

TEST_F(Painting, BesideTheSurfaceTurnsTheView) {
  takeSeedBrush();
  const PointSet before = points();
  const float yaw = scan().camera.yaw();
  drag({{8, center().y()}, {120, center().y()}});
  EXPECT_NE(scan().camera.yaw(), yaw);
  EXPECT_TRUE(identical(points(), before));
}

TEST_F(Painting, ControlErasesAndShiftLeavesLabelsThatAgree) {
  takeSeedBrush();
  drag(stroke());
  const auto countPainted = [this] { return std::ranges::count(points().values<std::int32_t>("seeds"), 1); };
  const auto painted = countPainted();
  drag({center() + QPoint(-10, 0), center() + QPoint(10, 0)}, Qt::ShiftModifier);
  EXPECT_EQ(countPainted(), painted) << "inside, all labels are the same already";
  drag(stroke(), Qt::ControlModifier);
  EXPECT_EQ(countPainted(), 0);
}

TEST_F(Painting, BracketsAndAltWheelChangeTheSize) {
  takeSeedBrush();
  moveTo(center());
  const double before = view().brush().radiusPx;
  key(Qt::Key_BracketRight);
  EXPECT_NEAR(view().brush().radiusPx, 1.1 * before, 1e-6 * before);
  key(Qt::Key_BracketLeft);
  EXPECT_NEAR(view().brush().radiusPx, before, 1e-6 * before);
  turnWheel(center(), 1, Qt::AltModifier);
  EXPECT_NEAR(view().brush().radiusPx, 1.1 * before, 1e-6 * before);
}

// Whatever is asked for in the middle of a stroke: nothing is lost and nothing ends the program.
TEST_F(Painting, CommandsInTheMiddleOfAStrokeHarmNothing) {
  takeSeedBrush();
  choose("tool_rectangle");
  drag({center() + QPoint(-50, -50), center()});
  ASSERT_TRUE(points().has("selection"));
  click(*find<QPushButton>("paint_seeds"));
  drag({center() + QPoint(0, 70), center() + QPoint(20, 70)});
  const PointSet before = points();
  press(center());
  moveTo(center() + QPoint(20, 0));
  ASSERT_TRUE(scan().document.isInStroke());
  for (const char* command :
       {"delete_selection", "flip_normals", "select_none", "undo", "run", "tool_orbit"}) {
    if (window().commands().action(command)->isEnabled()) choose(command);
  }
  moveTo(center() + QPoint(40, 0));
  release(center() + QPoint(40, 0));
  waitUntilIdle();
  EXPECT_FALSE(scan().document.isInStroke());
  EXPECT_EQ(points().size(), before.size());
  clickHistory(0);
  EXPECT_FALSE(points().has("seeds"));
}

TEST_F(Painting, ClosingInTheMiddleOfAStrokeEndsIt) {
  takeSeedBrush();
  open(writeSphere("other.ply", 3000));
  waitFor("the brush", [this] { return scan().hasDistance(); });
  press(center());
  moveTo(center() + QPoint(20, 0));
  ASSERT_TRUE(scan().document.isInStroke());
  workbench().close(1);
  waitForPicture();
  const PointSet before = points();
  moveTo(center() + QPoint(40, 0));
  release(center() + QPoint(40, 0));
  EXPECT_TRUE(identical(points(), before)) << "the stroke went on in another scan";
  EXPECT_FALSE(scan().document.isInStroke());
}

}  // namespace
}  // namespace stipple
