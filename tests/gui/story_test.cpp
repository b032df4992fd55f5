// The whole story with the program itself, and the same by the command line.
#include <QListWidget>
#include <QPushButton>
#include <QStatusBar>

#include "core/io/point_io.h"
#include "render/appearance/colormap.h"
#include "tests/gui/robot.h"
#include "tests/gui/window_test.h"
#include "tests/support/program_run.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

/// Where things are on the screen when the program shows the bunny, and two places of it to paint.
struct Places {
  QPoint paintSeeds, background;
  QRect view, history, status;  // of the history the first row, of the status line the right half
  std::vector<QPoint> firstStroke, secondStroke;
};

/// Keeps what the screen shows where the test has failed until then.
class PictureOfFailure {
 public:
  explicit PictureOfFailure(Robot& robot) : robot_(robot) {}
  ~PictureOfFailure() {
    if (!testing::Test::HasFailure()) return;
    if (!robot_.isRunning()) ADD_FAILURE() << "the program has ended, exit code " << robot_.waitForEnd();
    const auto path = std::filesystem::path(STIPPLE_BINARY_DIR) / "tests/story_failure.png";
    Robot::screen().save(QString::fromStdString(path.string()));
    ADD_FAILURE() << "the screen is in " << path;
  }

 private:
  Robot& robot_;
};

class Story : public WindowTest, public testing::WithParamInterface<const char*> {
 protected:
  /// Measures them in a window of this process, which looks like the program's.
  Places findPlaces(const std::filesystem::path& bunny) {
    open(bunny);
    QWidget& picture = view().viewport().widget();
    // The program's window will stand in the corner of the screen.
    const auto global = [this](const QWidget& widget, const QPoint& at) {
      return widget.mapTo(&window(), at);
    };
    QWidget* paint = find<QPushButton>("paint_seeds");
    Places places{.paintSeeds = global(*paint, paint->rect().center()),
                  .background = global(picture, {picture.width() - 12, picture.height() / 2}),
                  .view = {global(picture, {0, 0}), picture.size()},
                  .history = history().visualItemRect(history().item(0)),
                  .status = {global(*window().statusBar(), window().statusBar()->rect().center()),
                             global(*window().statusBar(), window().statusBar()->rect().bottomRight())},
                  .firstStroke = {},
                  .secondStroke = {}};
    places.history.moveTopLeft(global(*history().viewport(), places.history.topLeft()));
    const QPoint first = center() + QPoint(0, 50), second = findOnSurface({0, -1});
    for (const int x : {-10, 0, 10}) {
      places.firstStroke.push_back(global(picture, first + QPoint(x, 0)));
      places.secondStroke.push_back(global(picture, second + QPoint(x, 0)));
    }
    EXPECT_TRUE(window().close());
    endWindow();
    return places;
  }

  /// The farthest place from the middle in this direction that has surface around it.
  QPoint findOnSurface(const QPoint& direction) {
    const auto isSurface = [this](const QPoint& at) {
      return view().viewport().pickAt({float(at.x()), float(at.y())}).has_value();
    };
    QPoint farthest = center();
    for (QPoint at = center(); view().viewport().widget().rect().contains(at); at += 4 * direction) {
      if (isSurface(at) && isSurface(at + QPoint(-24, 0)) && isSurface(at + QPoint(24, 0)) &&
          isSurface(at + 24 * direction))
        farthest = at;
    }
    return farthest;
  }

  static bool isPlain(const QImage& screen, const QRect& area) {
    const int y = area.center().y();
    for (int x = area.left() + 2; x < area.right() - 1; ++x) {
      if (screen.pixel(x, y) != screen.pixel(area.left() + 2, y)) return false;
    }
    return true;
  }

  /// Nothing is prepared or run: the status line tells of nothing, and the history shows so many entries.
  static bool isDone(const Places& places, int entries) {
    const QImage screen = Robot::screen();
    int shown = 0;
    while (!isPlain(screen, places.history.translated(0, shown * places.history.height()))) ++shown;
    return shown == entries && isPlain(screen, places.status);
  }

  // A patch of this color in the left half of the view, as the brush panel shows labels.
  static std::optional<QPoint> findSwatch(const Places& places, const Rgba8& color) {
    const QImage screen = Robot::screen();
    const QRgb wanted = qRgb(color.r, color.g, color.b);
    constexpr int kSide = 6;
    const auto isPatch = [&](int x, int y) {
      for (int i = 0; i < kSide * kSide; ++i) {
        if (screen.pixel(x + i % kSide, y + i / kSide) != wanted) return false;
      }
      return true;
    };
    const QRect& view = places.view;
    for (int y = view.top(); y < view.bottom() - kSide; ++y) {
      for (int x = view.left(); x < view.center().x(); ++x) {
        if (isPatch(x, y)) return QPoint(x + kSide / 2, y + kSide / 2);
      }
    }
    return {};
  }

  // The chosen label has a white rim.
  static bool isChosen(const QPoint& swatch) {
    const QImage around = Robot::screen().copy(QRect(swatch - QPoint(9, 16), swatch + QPoint(24, 24)));
    int white = 0;
    for (int y = 0; y < around.height(); ++y) {
      for (int x = 0; x < around.width(); ++x)
        white += QColor(around.pixel(x, y)).value() - QColor(around.pixel(x, y)).saturation() > 225;
    }
    return white > 20;
  }

  static void answerDialog(const QString& title, const std::filesystem::path& path) {
    ASSERT_TRUE(Robot::waitForWindow(title)) << title.toStdString();
    Robot::focus(title);
    Robot::key("ctrl+a");
    Robot::type(QString::fromStdString(path.string()));
    Robot::key("Return");
    ASSERT_TRUE(Robot::waitUntil([&] { return !Robot::showsWindow(title); })) << title.toStdString();
  }

  void paintTwoSeeds(const Places& places) {
    Robot::click(places.paintSeeds);
    std::optional<QPoint> second;
    ASSERT_TRUE(Robot::waitUntil([&] { return (second = findSwatch(places, labelColor(2))).has_value(); }));
    ASSERT_TRUE(Robot::waitUntil([&] { return isDone(places, 1); })) << "the brush is never ready";
    Robot::drag(places.firstStroke, places.background);
    ASSERT_TRUE(Robot::waitUntil([&] { return isDone(places, 2); })) << "the first stroke";
    Robot::click(*second);
    // A picture that takes long takes the click late.
    ASSERT_TRUE(Robot::waitUntil([&] { return isChosen(*second); }));
    Robot::drag(places.secondStroke, places.background);
    ASSERT_TRUE(Robot::waitUntil([&] { return isDone(places, 3); })) << "the second stroke";
  }

  static constexpr const char* kModified = "bunny.ply\\* - Stipple";
  static constexpr const char* kUnmodified = "bunny.ply - Stipple";
};

TEST_P(Story, SavesWhatTheCommandLineMakesOfItsRecipe) {
  STIPPLE_NEEDS_TEST_DATA();
  const auto bunny = folder_ / "bunny.ply", original = folder_ / "original.ply",
             recipe = folder_ / "recipe.json";
  std::filesystem::copy_file(testData("smooth/bun_zipper_binary_le_points.ply"), bunny);
  std::filesystem::copy_file(bunny, original);
  const Places places = findPlaces(bunny);
  const std::filesystem::path programs = std::filesystem::path(STIPPLE_BINARY_DIR) / "bin";

  Robot robot(programs / "stipple", {"--backend", GetParam(), QString::fromStdString(bunny.string())});
  const PictureOfFailure picture(robot);
  ASSERT_TRUE(Robot::waitForWindow(kUnmodified));
  Robot::moveToCorner(kUnmodified);
  Robot::focus(kUnmodified);
  const QPoint onBunny = places.firstStroke[1];
  ASSERT_TRUE(Robot::waitUntil([&] { return Robot::colorAt(onBunny) != Robot::colorAt(places.background); }));

  paintTwoSeeds(places);
  if (HasFatalFailure()) return;
  Robot::key("ctrl+r");
  ASSERT_TRUE(Robot::waitUntil([&] { return isDone(places, 4); })) << "the segmentation";
  for (int i = 0; i < 3; ++i) Robot::key("ctrl+z");
  ASSERT_TRUE(Robot::waitForWindow(kUnmodified)) << "undone to the start, nothing is to be saved";
  for (int i = 0; i < 3; ++i) Robot::key("ctrl+shift+z");
  ASSERT_TRUE(Robot::waitForWindow(kModified));
  Robot::key("ctrl+s");
  ASSERT_TRUE(Robot::waitForWindow(kUnmodified));

  Robot::key("ctrl+space");
  Robot::type("save recipe");
  Robot::key("Return");
  answerDialog("Save recipe", recipe);
  ASSERT_TRUE(Robot::waitUntil([&] { return std::filesystem::exists(recipe); }));

  Robot::focus(kUnmodified);
  Robot::key("ctrl+w");
  ASSERT_TRUE(Robot::waitForWindow("Stipple"));
  Robot::key("ctrl+o");
  answerDialog("Open scans", bunny);
  ASSERT_TRUE(Robot::waitForWindow(kUnmodified));
  Robot::focus(kUnmodified);
  Robot::key("ctrl+shift+s");
  answerDialog("Save as", folder_ / "again.ply");
  ASSERT_TRUE(Robot::waitForWindow("again.ply - Stipple"));
  Robot::focus("again.ply - Stipple");
  Robot::key("ctrl+q");
  EXPECT_EQ(robot.waitForEnd(), 0);

  const ProgramRun played =
      runProgram(programs / "stipple-cli", {"play", recipe, original, "-o", folder_ / "played.ply"});
  ASSERT_EQ(played.exitCode, 0) << played.err;
  const std::string saved = contentOf(bunny);
  EXPECT_TRUE(saved == contentOf(folder_ / "played.ply"))
      << "the command line makes another file of the same recipe";
  EXPECT_TRUE(saved == contentOf(folder_ / "again.ply")) << "reading and writing again changed something";
  Progress progress;
  const PointSet made = readPoints(bunny, progress).points;
  for (const int label : {1, 2}) {
    EXPECT_GT(std::ranges::count(made.values<std::int32_t>("seeds"), label), 0) << label;
    EXPECT_GT(std::ranges::count(made.values<std::int32_t>("segment"), label), 0) << label;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Story, testing::Values(STIPPLE_STORY_BACKEND),
                         [](const auto& chosen) { return std::string(chosen.param); });

}  // namespace
}  // namespace stipple
