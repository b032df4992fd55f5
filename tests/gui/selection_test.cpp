#include <QLabel>
#include <QTest>
#include <QTreeWidget>

#include "app/tools/graph_selection.h"
#include "app/tools/selection.h"
#include "app/window/histogram.h"
#include "tests/gui/window_test.h"
#include "tests/support/identical.h"

namespace stipple {
namespace {

constexpr float kEdge = 1.5f;  // pixels beside an outline where rounding decides

class SelectionByHand : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    openSphere(20000);
  }

  SelectionMask selected() { return selectionOf(points()); }
  Index count() { return countSelected(selected()); }

  // On the half of the sphere that is seen, and not near its rim.
  bool isSeen(Index row) {
    const Eigen::Vector3f& p = points().positions()[row];
    const glm::vec3 normal(p.x(), p.y(), p.z());
    return glm::dot(glm::normalize(scan().camera.eye() - normal), normal) > 0.2f;
  }
  bool isHidden(Index row) {
    const Eigen::Vector3f& p = points().positions()[row];
    const glm::vec3 normal(p.x(), p.y(), p.z());
    return glm::dot(glm::normalize(scan().camera.eye() - normal), normal) < -0.2f;
  }

  /// Distance inside the box, negative outside.
  static float depthIn(const QRect& box, const glm::vec2& p) {
    return std::min({p.x - float(box.left()), float(box.right()) - p.x, p.y - float(box.top()),
                     float(box.bottom()) - p.y});
  }

  void dragRectangle(const QRect& box, Qt::KeyboardModifiers held = {}) {
    choose("tool_rectangle");
    drag({box.topLeft(), box.bottomRight()}, held);
  }

  QRect middleBox() { return {center() - QPoint(80, 50), center() + QPoint(60, 70)}; }
};

TEST_F(SelectionByHand, RectangleTakesWhatIsSeenInIt) {
  dragRectangle(middleBox());
  const SelectionMask mask = selected();
  ASSERT_GT(count(), 0u);
  for (Index row = 0; row < points().size(); ++row) {
    const float depth = depthIn(middleBox(), pixelOf(row));
    if (depth > kEdge && isSeen(row)) {
      EXPECT_EQ(mask[row], 1);
    }
    if (depth < -kEdge || isHidden(row)) {
      EXPECT_EQ(mask[row], 0);
    }
  }
  EXPECT_EQ(find<QLabel>("selection")->text().remove(',').toStdString(),
            std::to_string(count()) + " selected");
  EXPECT_EQ(scan().document.history().size(), 1u);
}

TEST_F(SelectionByHand, ShiftAddsAndControlRemoves) {
  dragRectangle(middleBox());
  const Index first = count();
  const QRect other = middleBox().translated(150, 0);
  dragRectangle(other, Qt::ShiftModifier);
  const Index both = count();
  EXPECT_GT(both, first);
  dragRectangle(other, Qt::ControlModifier);
  EXPECT_EQ(count(), first);
  EXPECT_EQ(scan().document.history().size(), 3u);
}

TEST_F(SelectionByHand, LassoFollowsItsLine) {
  choose("tool_lasso");
  const std::vector<QPoint> triangle{center() + QPoint(-90, 60), center() + QPoint(90, 60),
                                     center() + QPoint(0, -90)};
  drag({triangle[0], triangle[1], triangle[2], triangle[0]});
  const SelectionMask mask = selected();
  ASSERT_GT(count(), 0u);
  const auto depth = [&](const glm::vec2& p) {
    float least = 1e9f;
    for (int i = 0; i < 3; ++i) {
      const QPoint a = triangle[i], way = triangle[(i + 1) % 3] - a;
      const glm::vec2 along(way.x(), way.y()), to = p - glm::vec2(a.x(), a.y());
      least = std::min(least, (along.y * to.x - along.x * to.y) / glm::length(along));
    }
    return least;
  };
  for (Index row = 0; row < points().size(); ++row) {
    const float inside = depth(pixelOf(row));
    if (inside > 2 * kEdge && isSeen(row)) {
      EXPECT_EQ(mask[row], 1);
    }
    if (inside < -2 * kEdge || isHidden(row)) {
      EXPECT_EQ(mask[row], 0);
    }
  }
}

TEST_F(SelectionByHand, EscapeDropsTheOutline) {
  choose("tool_rectangle");
  press(center());
  moveTo(center() + QPoint(50, 50));
  key(Qt::Key_Escape);
  release(center() + QPoint(50, 50));
  EXPECT_FALSE(points().has(kSelection));
  EXPECT_EQ(scan().document.history().size(), 0u);
}

TEST_F(SelectionByHand, AllNothingAndInvertByKeys) {
  key(Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(count(), points().size());
  dragRectangle(middleBox());
  const Index inside = count();
  key(Qt::Key_I, Qt::ControlModifier);
  EXPECT_EQ(count(), points().size() - inside);
  key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(count(), 0u);
  EXPECT_FALSE(points().has(kSelection));
}

TEST_F(SelectionByHand, GrowAndShrinkByKeys) {
  dragRectangle(middleBox());
  const Index inside = count();
  choose("select_grow");
  waitUntilIdle();
  const Index grown = count();
  EXPECT_GT(grown, inside);
  choose("select_shrink");
  waitUntilIdle();
  EXPECT_LT(count(), grown);
}

// What is wanted while neighbors are found follows in its order; each is one step of the history.
TEST_F(SelectionByHand, GrowsAsOftenAsItWasWantedMeanwhile) {
  dragRectangle(middleBox());
  const NeighborGraph graph = buildNeighborGraph(points());
  const SelectionMask wanted = shrink(graph, grow(graph, grow(graph, selected())));
  const std::size_t before = scan().document.history().size();
  for (const char* command : {"select_grow", "select_grow", "select_shrink"}) choose(command);
  waitUntilIdle();
  EXPECT_EQ(selected(), wanted);
  EXPECT_EQ(scan().document.history().size(), before + 3);
}

TEST_F(SelectionByHand, GrowingGoesOnBesideTheWindowAndCanBeCancelled) {
  openSphere(400000);
  key(Qt::Key_A, Qt::ControlModifier);
  dragRectangle(middleBox());
  const SelectionMask before = selected();
  workbench().widenSelection(Workbench::Widening::kGrow);
  ASSERT_TRUE(workbench().task()) << "nothing is computed before the command returns";
  workbench().cancelTask();
  waitUntilIdle();
  EXPECT_EQ(selected(), before);
  EXPECT_THAT(said_, testing::IsEmpty());
  choose("select_grow");
  waitUntilIdle();
  EXPECT_GT(count(), countSelected(before));
}

TEST_F(SelectionByHand, ByValueInTheHistogram) {
  auto* list = find<QTreeWidget>("attributes");
  QTreeWidgetItem* altitude = list->findItems("altitude", Qt::MatchExactly).value(0);
  ASSERT_NE(altitude, nullptr);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(altitude).center());
  auto* histogram = window().findChild<Histogram*>();
  waitFor("the histogram", [&] {
    return histogram->isVisible() && histogram->height() >= histogram->minimumSizeHint().height();
  });
  // The right quarter of [-1, 1].
  const int width = histogram->width();
  QTest::mousePress(histogram, Qt::LeftButton, {}, {4 + (width - 8) * 3 / 4, 10});
  QTest::mouseMove(histogram, {width - 4, 10});
  QTest::mouseRelease(histogram, Qt::LeftButton, {}, {width - 4, 10});
  const SelectionMask mask = selected();
  const auto values = points().values<float>("altitude");
  const float pixel = 2.0f / static_cast<float>(width - 8);
  for (Index row = 0; row < points().size(); ++row) {
    if (values[row] > 0.5f + 2 * pixel) {
      EXPECT_EQ(mask[row], 1) << values[row];
    }
    if (values[row] < 0.5f - 2 * pixel) {
      EXPECT_EQ(mask[row], 0) << values[row];
    }
  }
}

TEST_F(SelectionByHand, DeletedPointsComeBack) {
  dragRectangle(middleBox());
  const PointSet before = points();
  const SelectionMask mask = selected();
  const Index left = points().size() - count();
  key(Qt::Key_Delete);
  EXPECT_EQ(points().size(), left);
  waitForPicture();
  // The rest is in its order.
  Index at = 0;
  for (Index row = 0; row < before.size(); ++row) {
    if (mask[row] == 0) {
      ASSERT_EQ(points().positions()[at++], before.positions()[row]);
    }
  }
  // One sees through the hole to the far side.
  const glm::vec2 middle(center().x(), center().y());
  waitFor("the hole in the picture", [&] {
    const auto picked = view().viewport().pickAt(middle);
    return picked && glm::dot(picked->position, scan().camera.eye()) < 0;
  });
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(identical(points(), before));
  waitFor("the closed picture", [&] {
    const auto picked = view().viewport().pickAt(middle);
    return picked && glm::dot(picked->position, scan().camera.eye()) > 0;
  });
}

}  // namespace
}  // namespace stipple
