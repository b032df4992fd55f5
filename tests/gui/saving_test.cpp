#include <QMessageBox>
#include <QPushButton>
#include <QTest>

#include "core/io/point_io.h"
#include "tests/gui/window_test.h"
#include "tests/support/identical.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

class Saving : public WindowTest {
 protected:
  void paintSeeds() {
    chooseOperator("segmentation");
    click(*find<QPushButton>("paint_seeds"));
    waitFor("the brush", [this] { return scan().hasDistance(); });
    waitForPicture();
    drag({center() + QPoint(-20, 0), center() + QPoint(20, 0)});
    ASSERT_TRUE(scan().document.isModified());
  }

  void saveAs(const std::filesystem::path& path) {
    answerFileDialog(path);
    key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    waitUntilIdle();
  }

  /// What the box about unsaved changes is answered when it opens.
  void answerUnsaved(QMessageBox::StandardButton answer) {
    whenDialogOpens([answer](QWidget& dialog) {
      auto* box = qobject_cast<QMessageBox*>(&dialog);
      ASSERT_TRUE(box && box->objectName() == "unsaved");
      click(*box->button(answer));
    });
  }

  static PointSet read(const std::filesystem::path& path) {
    Progress progress;
    return readPoints(path, progress).points;
  }

  /// Values of all attributes and positions; what a file says of its columns may differ.
  static void expectSameValues(const PointSet& a, const PointSet& b) {
    EXPECT_TRUE(sameBits(a.positionColumn().values(), b.positionColumn().values()));
    ASSERT_EQ(a.attributes().size(), b.attributes().size());
    for (const Attribute& attribute : a.attributes()) {
      const Attribute* other = b.find(attribute.name);
      ASSERT_NE(other, nullptr) << attribute.name;
      EXPECT_TRUE(sameBits(attribute.column.values(), other->column.values())) << attribute.name;
    }
  }
};

TEST_F(Saving, ReloadedPointsAreTheSameToTheBit) {
  const auto path = writeSphere("sphere.ply");
  open(path);
  paintSeeds();
  const PointSet painted = points();
  key(Qt::Key_S, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_FALSE(scan().document.isModified());
  EXPECT_FALSE(window().isWindowModified());
  expectSameValues(painted, read(path));
  open(path);
  ASSERT_THAT(workbench().scans(), SizeIs(2));
  expectSameValues(painted, points());
  EXPECT_FALSE(scan().document.isModified());
}

TEST_F(Saving, UndoneAfterSavingIsModified) {
  openSphere();
  paintSeeds();
  key(Qt::Key_S, Qt::ControlModifier);
  waitUntilIdle();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(scan().document.isModified());
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(scan().document.isModified());
}

TEST_F(Saving, ObjSaysWhatIsLostAndTheChangesStayUnsaved) {
  openSphere();
  paintSeeds();
  said_.clear();
  saveAs(folder_ / "sphere.obj");
  ASSERT_THAT(said_, SizeIs(1));
  EXPECT_THAT(said_[0].toStdString(), HasSubstr("sphere.obj"));
  EXPECT_THAT(said_[0].toStdString(), HasSubstr("PLY"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "sphere.obj"));
  EXPECT_TRUE(scan().document.isModified());
  EXPECT_EQ(scan().document.path().filename(), "sphere.ply");
  EXPECT_EQ(read(folder_ / "sphere.obj").size(), points().size());
}

TEST_F(Saving, WhereNothingCanBeWrittenChangesStayUnsaved) {
  openSphere();
  paintSeeds();
  said_.clear();
  workbench().save(folder_ / "missing" / "sphere.ply");
  waitUntilIdle();
  EXPECT_THAT(said_, SizeIs(1));
  EXPECT_TRUE(scan().document.isModified());
}

TEST_F(Saving, OfASampleAsksWhere) {
  choose("sample");
  waitFor("the sample", [this] { return workbench().current() != nullptr; });
  waitUntilIdle();
  const auto bundled = scan().document.path();
  const auto written = std::filesystem::last_write_time(bundled);
  workbench().flipNormals();
  answerFileDialog(folder_ / "mine.ply");
  key(Qt::Key_S, Qt::ControlModifier);
  waitUntilIdle();
  EXPECT_TRUE(std::filesystem::exists(folder_ / "mine.ply"));
  EXPECT_EQ(std::filesystem::last_write_time(bundled), written);
  EXPECT_FALSE(scan().isSample);
}

TEST_F(Saving, ClosingAsksAndCancelKeepsEverything) {
  openSphere();
  paintSeeds();
  const PointSet painted = points();
  answerUnsaved(QMessageBox::Cancel);
  EXPECT_FALSE(window().close());
  EXPECT_TRUE(dialogWasDriven());
  EXPECT_TRUE(window().isVisible());
  ASSERT_THAT(workbench().scans(), SizeIs(1));
  EXPECT_TRUE(identical(points(), painted));
  answerUnsaved(QMessageBox::Cancel);
  key(Qt::Key_W, Qt::ControlModifier);
  ASSERT_THAT(workbench().scans(), SizeIs(1));
}

TEST_F(Saving, ClosingAsksAndDiscardCloses) {
  const auto path = writeSphere("sphere.ply");
  const std::string content = contentOf(path);
  open(path);
  paintSeeds();
  answerUnsaved(QMessageBox::Discard);
  EXPECT_TRUE(window().close());
  EXPECT_TRUE(dialogWasDriven());
  EXPECT_FALSE(window().isVisible());
  EXPECT_EQ(contentOf(path), content);
}

TEST_F(Saving, ClosingAsksAndSaves) {
  const auto path = writeSphere("sphere.ply");
  open(path);
  paintSeeds();
  const PointSet painted = points();
  answerUnsaved(QMessageBox::Save);
  EXPECT_TRUE(window().close());
  expectSameValues(painted, read(path));
}

TEST_F(Saving, ClosingUntouchedAsksNothing) {
  openSphere();
  EXPECT_TRUE(window().close());
  EXPECT_FALSE(window().isVisible());
}

TEST_F(Saving, RecipePlaysOnTheSamePointsWithTheSameResult) {
  const auto path = writeSphere("sphere.ply");
  open(path);
  paintSeeds();
  click(*find<QPushButton>("run"));
  waitUntilIdle();
  ASSERT_TRUE(points().has("segment"));
  const PointSet made = points();
  answerFileDialog(folder_ / "done.json");
  choose("save_recipe");
  ASSERT_TRUE(std::filesystem::exists(folder_ / "done.json"));
  clickHistory(0);
  ASSERT_FALSE(points().has("seeds"));
  answerFileDialog(folder_ / "done.json");
  choose("play_recipe");
  waitUntilIdle();
  expectSameValues(made, points());
  EXPECT_EQ(scan().document.history().size(), 2u);
}

TEST_F(Saving, ARecipeKnowsFlippedNormalsButNoSelection) {
  openSphere();
  workbench().flipNormals();
  EXPECT_EQ(scan().document.recipe().recipe.steps.size(), 1u);
  EXPECT_EQ(scan().document.recipe().leftOut, 0u);
  choose("select_all");
  workbench().flipNormals();
  EXPECT_EQ(scan().document.recipe().recipe.steps.size(), 1u);
  EXPECT_EQ(scan().document.recipe().leftOut, 2u) << "what is selected belongs to this scan";
}

}  // namespace
}  // namespace stipple
