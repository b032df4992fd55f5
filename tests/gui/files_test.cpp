#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QUrl>

#include "tests/gui/window_test.h"
#include "tests/support/identical.h"

namespace stipple {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::SizeIs;

class Files : public WindowTest {
 protected:
  /// Lets the window read it and looks that one sentence is all that comes of it.
  void expectRefused(const std::filesystem::path& path, const char* reason) {
    const PointSet before = points();
    const std::uint64_t revision = scan().document.revision();
    const QString title = window().windowTitle();
    said_.clear();
    workbench().open(path);
    waitUntilIdle();
    ASSERT_THAT(said_, SizeIs(1)) << path;
    const std::string sentence = said_[0].toStdString();
    EXPECT_THAT(sentence, HasSubstr(path.filename().string()));
    EXPECT_THAT(sentence, HasSubstr(reason));
    EXPECT_EQ(sentence.back(), '.');
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    EXPECT_THAT(workbench().scans(), SizeIs(1));
    EXPECT_EQ(scan().document.revision(), revision);
    EXPECT_TRUE(identical(points(), before));
    EXPECT_EQ(window().windowTitle(), title);
  }

  void drop(const std::vector<std::filesystem::path>& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const auto& path : paths) urls << QUrl::fromLocalFile(QString::fromStdString(path.string()));
    data.setUrls(urls);
    QDragEnterEvent enter(center(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(center(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window(), &event);
  }

  std::filesystem::path writeBroken() {
    setContent(folder_ / "broken.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n");
    return folder_ / "broken.ply";
  }
};

TEST_F(Files, OpensOneByTheDialog) {
  openSphere(2000);
  EXPECT_EQ(points().size(), 2000u);
  EXPECT_TRUE(points().has("altitude"));
  EXPECT_FALSE(scan().document.isModified());
  EXPECT_THAT(window().windowTitle().toStdString(), HasSubstr("sphere.ply"));
  EXPECT_FALSE(dialogWasDriven() && !said_.empty()) << said_.front().toStdString();
  // The picture shows a surface in its middle and the background in its corner.
  const glm::vec2 middle(center().x(), center().y());
  const auto picked = view().viewport().pickAt(middle);
  ASSERT_TRUE(picked);
  EXPECT_NEAR(glm::length(picked->position), 1, 0.02) << "not on the unit sphere";
  EXPECT_FALSE(view().viewport().pickAt({2, 2}));
}

TEST_F(Files, RefusesAMissingOne) {
  openSphere();
  expectRefused(folder_ / "missing.ply", "");
}

TEST_F(Files, RefusesABrokenOne) {
  openSphere();
  expectRefused(writeBroken(), "");
}

TEST_F(Files, RefusesAnEmptyOne) {
  openSphere();
  setContent(folder_ / "empty.ply", "");
  expectRefused(folder_ / "empty.ply", "empty");
}

TEST_F(Files, RefusesAFolder) {
  openSphere();
  std::filesystem::create_directory(folder_ / "folder.ply");
  expectRefused(folder_ / "folder.ply", "directory");
}

TEST_F(Files, DropsABrokenOneAndKeepsOn) {
  openSphere();
  const PointSet before = points();
  drop({writeBroken()});
  waitUntilIdle();
  EXPECT_THAT(said_, SizeIs(1));
  EXPECT_THAT(workbench().scans(), SizeIs(1));
  EXPECT_TRUE(identical(points(), before));
}

TEST_F(Files, DropsSeveral) {
  const auto first = writeSphere("first.ply", 500), second = writeSphere("second.ply", 700);
  drop({first, writeBroken(), second});
  waitUntilIdle();
  ASSERT_THAT(workbench().scans(), SizeIs(2));
  EXPECT_EQ(workbench().scans()[0]->document.points().size(), 500u);
  EXPECT_EQ(workbench().scans()[1]->document.points().size(), 700u);
  EXPECT_THAT(said_, SizeIs(1));
}

TEST_F(Files, OpensTheSampleWithoutAName) {
  choose("sample");
  waitFor("the sample", [this] { return workbench().current() != nullptr; });
  waitUntilIdle();
  waitForPicture();
  EXPECT_TRUE(scan().isSample);
  EXPECT_GT(points().size(), 1000u);
  EXPECT_TRUE(said_.empty());
}

}  // namespace
}  // namespace stipple
