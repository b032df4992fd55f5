#include <QElapsedTimer>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>
#include <set>

#include "tests/gui/window_test.h"
#include "tests/support/identical.h"

namespace stipple {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;

class Process : public WindowTest {
 protected:
  void pressRun() { click(*find<QPushButton>("run")); }
  void pressPanel(const char* button) { click(*find<QToolButton>(button)); }
  int steps() { return workbench().process() ? workbench().process()->steps : -1; }
  float height() { return points().values<float>("height")[0]; }

  void seedTheSphere() {
    click(*find<QPushButton>("paint_seeds"));
    waitFor("the brush", [this] { return scan().hasDistance(); });
    waitForPicture();
    drag({center() + QPoint(-20, 0), center() + QPoint(20, 0)});
  }
};

TEST_F(Process, ClassifierRunsToItsEnd) {
  openSphere();
  const PointSet before = points();
  chooseOperator("classifier");
  pressRun();
  EXPECT_TRUE(workbench().isRunning());
  waitUntilIdle();
  ASSERT_TRUE(points().has("classifier"));
  // Everywhere alike on a sphere, and in (0, 1].
  for (const float value : points().values<float>("classifier")) {
    EXPECT_GT(value, 0);
    EXPECT_LE(value, 1);
  }
  ASSERT_EQ(history().count(), 2);
  EXPECT_EQ(history().currentRow(), 1);
  EXPECT_EQ(scan().look.colors.attribute, "classifier") << "the result is not what is shown";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(identical(points(), before));
}

TEST_F(Process, TriangulationShowsItsTriangles) {
  openSphere();
  QAction* mesh = window().commands().action("mesh");
  EXPECT_FALSE(mesh->isEnabled());
  chooseOperator("triangulation");
  pressRun();
  waitUntilIdle();
  // A closed surface: V - E + F = 2 and 3 F = 2 E.
  EXPECT_EQ(points().triangles().size(), 2u * points().size() - 4);
  EXPECT_TRUE(mesh->isEnabled() && mesh->isChecked());
  EXPECT_TRUE(waitFor(
      "triangles, not splats", [this] { return view().viewport().notes()->splats == 0; }, 5000));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(points().triangles().empty());
  EXPECT_FALSE(mesh->isEnabled());
  EXPECT_TRUE(waitFor(
      "splats again", [this] { return view().viewport().notes()->splats > 0; }, 5000));
}

TEST_F(Process, SegmentationGrowsFromPaintedSeeds) {
  openSphere();
  chooseOperator("segmentation");
  seedTheSphere();
  const PointSet before = points();
  const auto seeds = before.values<std::int32_t>("seeds");
  key(Qt::Key_R, Qt::ControlModifier);
  EXPECT_TRUE(workbench().isRunning());
  waitUntilIdle();
  ASSERT_TRUE(points().has("segment")) << (said_.empty() ? "" : said_.back().toStdString());
  const auto segment = points().values<std::int32_t>("segment");
  EXPECT_EQ(std::set<int>(segment.begin(), segment.end()).contains(1), true);
  for (Index row = 0; row < points().size(); ++row) {
    if (seeds[row] == 1) {
      EXPECT_EQ(segment[row], 1) << "a seed lost its label";
    }
  }
  // A sphere has no crease to stop at: the one label covers more than was painted.
  EXPECT_GT(std::ranges::count(segment, 1), 4 * std::ranges::count(seeds, 1));
  EXPECT_EQ(history().count(), 3) << "stroke and run";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(identical(points(), before));
}

TEST_F(Process, CancelLeavesTheSurfaceAsItWas) {
  openSphere();
  const PointSet before = points();
  chooseOperator("stepper", {{"steps", 100000}, {"milliseconds", 20}});
  pressRun();
  waitFor("some steps", [this] { return steps() >= 2; });
  EXPECT_TRUE(identical(points(), before)) << "a running process is no edit";
  QElapsedTimer timer;
  timer.start();
  key(Qt::Key_Escape);
  EXPECT_FALSE(workbench().isRunning());
  workbench().flipNormals();
  EXPECT_EQ(scan().document.history().size(), 1u) << "not editable";
  RecordProperty("milliseconds_to_editable", static_cast<int>(timer.elapsed()));
  EXPECT_LT(timer.elapsed(), 5000);
  workbench().undo();
  EXPECT_TRUE(identical(points(), before));
  EXPECT_FALSE(points().has("height"));
}

TEST_F(Process, SegmentationIsCancelledInTheMiddle) {
  openSphere(60000);
  chooseOperator("segmentation", {{"steps", 100000}});
  seedTheSphere();
  const PointSet before = points();
  pressRun();
  ASSERT_TRUE(workbench().isRunning());
  waitFor("the first step or the end", [this] { return steps() != 0; });
  const bool isInTheMiddle = workbench().isRunning();
  pressPanel("process_cancel");
  EXPECT_TRUE(isInTheMiddle) << "it ended before it could be cancelled";
  EXPECT_FALSE(workbench().isRunning());
  EXPECT_TRUE(identical(points(), before));
  EXPECT_EQ(scan().document.history().size(), 1u);
}

TEST_F(Process, IsPausedSteppedAndStopped) {
  openSphere(1000);
  chooseOperator("stepper", {{"steps", 100000}, {"milliseconds", 5}});
  pressRun();
  waitFor("some steps", [this] { return steps() >= 2; });
  pressPanel("process_pause");
  waitFor("the pause", [this] { return workbench().process()->isPaused; });
  // The step that was going on when it was paused may still end.
  waitFor("a quiet process", [this] { return !workbench().process()->isInStep; });
  const int at = steps();
  pressPanel("process_step");
  waitFor("one step", [&] { return steps() == at + 1; });
  pressPanel("process_step");
  waitFor("another step", [&] { return steps() == at + 2; });
  pressPanel("process_stop");
  waitUntilIdle();
  // The stepper adds 1 a step.
  EXPECT_EQ(height(), static_cast<float>(at + 2));
  EXPECT_EQ(scan().document.history().size(), 1u);
  workbench().undo();
  EXPECT_FALSE(points().has("height"));
}

TEST_F(Process, BeginsPausedWhereTheFirstStepIsAskedFor) {
  openSphere(1000);
  chooseOperator("stepper", {{"steps", 10}});
  pressPanel("process_step");
  waitFor("the step", [this] { return steps() >= 0; });
  ASSERT_TRUE(workbench().process()->isPaused);
  pressPanel("process_pause");  // goes on
  waitUntilIdle();
  EXPECT_EQ(height(), 10.0f);
}

TEST_F(Process, ParametersActWhileItRuns) {
  openSphere(1000);
  chooseOperator("stepper", {{"steps", 100000}, {"milliseconds", 10}});
  pressRun();
  waitFor("a step", [this] { return steps() >= 1; });
  chooseOperator("stepper", {{"steps", 3}});
  waitUntilIdle();
  EXPECT_TRUE(points().has("height")) << "three steps were asked for, so it ended by itself";
}

TEST_F(Process, PaintingGoesOnMeanwhile) {
  openSphere();
  chooseOperator("segmentation");
  click(*find<QPushButton>("paint_seeds"));
  waitFor("the brush", [this] { return scan().hasDistance(); });
  chooseOperator("stepper", {{"steps", 100000}, {"milliseconds", 5}});
  const PointSet before = points();
  pressRun();
  waitFor("a step", [this] { return steps() >= 1; });
  drag({center() + QPoint(-20, 0), center() + QPoint(20, 0)});
  ASSERT_TRUE(points().has("seeds")) << "not painted while a process runs";
  const PointSet painted = points();
  EXPECT_TRUE(workbench().isRunning());
  pressPanel("process_stop");
  waitUntilIdle();
  // Both are there, each can be undone.
  EXPECT_TRUE(points().has("height"));
  EXPECT_TRUE(sameBits(points().find("seeds")->column.values(), painted.find("seeds")->column.values()));
  EXPECT_EQ(scan().document.history().size(), 2u);
  workbench().undo();
  EXPECT_TRUE(identical(points(), painted));
  workbench().undo();
  EXPECT_TRUE(identical(points(), before));
}

TEST_F(Process, CannotBeUndoneFromUnderItsFeet) {
  openSphere(1000);
  workbench().flipNormals();
  const PointSet before = points();
  chooseOperator("stepper", {{"steps", 100000}, {"milliseconds", 5}});
  pressRun();
  said_.clear();
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_THAT(said_, SizeIs(1));
  EXPECT_THAT(said_[0].toStdString(), HasSubstr("Stepper"));
  EXPECT_TRUE(identical(points(), before));
  key(Qt::Key_Escape);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scan().document.history().position(), 0u);
}

TEST_F(Process, OneThatFailsSaysWhyAndLeavesTheSurface) {
  openSphere(1000);
  const PointSet before = points();
  for (const char* how : {"standard", "invalid_input", "number", "memory", "lose_points"}) {
    Invocation invocation = makeInvocation(workbench().registry(), "misbehave");
    invocation.parameters.set("how", std::string(how));
    said_.clear();
    workbench().run(invocation);
    waitUntilIdle();
    ASSERT_THAT(said_, SizeIs(1)) << how;
    EXPECT_EQ(said_[0].count('\n'), 0) << said_[0].toStdString();
    EXPECT_TRUE(identical(points(), before)) << how;
    EXPECT_EQ(scan().document.history().size(), 0u) << how;
    EXPECT_FALSE(scan().document.isModified()) << how;
  }
  // And it can be worked with as before.
  chooseOperator("stepper", {{"steps", 2}});
  pressRun();
  waitUntilIdle();
  EXPECT_EQ(height(), 2.0f);
}

TEST_F(Process, RowsThatGoComeBackByUndo) {
  openSphere(1000);
  const PointSet before = points();
  chooseOperator("thin_out");
  pressRun();
  waitUntilIdle();
  EXPECT_EQ(points().size(), 500u);
  waitForPicture();
  EXPECT_EQ(find<QLabel>("points")->text(), "500 points");
  workbench().undo();
  EXPECT_TRUE(identical(points(), before));
  EXPECT_EQ(find<QLabel>("points")->text(), "1,000 points");
}

TEST_F(Process, GoesWithItsScan) {
  openSphere(1000);
  chooseOperator("stepper", {{"steps", 100000}, {"milliseconds", 5}});
  pressRun();
  waitFor("a step", [this] { return steps() >= 1; });
  key(Qt::Key_W, Qt::ControlModifier);
  EXPECT_TRUE(workbench().scans().empty());
  EXPECT_FALSE(workbench().isRunning());
}

}  // namespace
}  // namespace stipple
