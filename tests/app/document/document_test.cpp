#include "app/document/document.h"

#include <gmock/gmock.h>

#include "tests/support/identical.h"
#include "tests/support/random_actions.h"
#include "tests/support/temporary_folder.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

PointSet startingPoints() {
  PointSet points(std::vector<Eigen::Vector3f>(200, Eigen::Vector3f(1, 2, 3)), {1, 2, 3});
  points.set("selection", std::vector<std::int32_t>(200, 0));
  return points;
}

// What a view would hold that only follows the changes.
class Mirror {
 public:
  explicit Mirror(const Document& document) : points_(document.points()), seen_(document.revision()) {}

  void follow(const Document& document) {
    const DocumentChange change = document.changedSince(seen_);
    seen_ = document.revision();
    if (change.everything) {
      points_ = document.points();
      return;
    }
    if (change.triangles) points_.setTriangles(document.points().triangles());
    for (const auto& [name, rows] : change.columns) {
      if (name.empty()) {
        copyRows(document.points().positionColumn(), points_.positionColumn(), rows.get());
      } else if (const Attribute* now = document.points().find(name); !now) {
        points_.erase(name);
      } else if (!rows) {
        points_.insert(*now);
      } else {
        copyRows(now->column, points_.find(name)->column, rows.get());
      }
    }
  }

  bool shows(const PointSet& points) const {
    if (points.attributes().size() != points_.attributes().size()) return false;
    for (const Attribute& attribute : points.attributes()) {
      const Attribute* mine = points_.find(attribute.name);
      if (!mine || !sameBits(mine->column.values(), attribute.column.values())) return false;
    }
    return sameBits(points.positionColumn().values(), points_.positionColumn().values()) &&
           points.triangles() == points_.triangles();
  }

 private:
  static void copyRows(const Column& from, Column& to, const std::vector<Index>* rows) {
    if (!rows) {
      to = from;
      return;
    }
    std::visit(
        [&](auto& values) {
          const auto& source = std::get<std::decay_t<decltype(values)>>(from.values());
          for (const Index row : *rows) values[row] = source[row];
        },
        to.edit());
  }

  PointSet points_;
  std::uint64_t seen_;
};

// A document at which somebody works at random, and the states that it should have.
class RandomWork {
 public:
  RandomWork(std::uint32_t seed, HistoryOptions options)
      : actions_(seed), document_(startingPoints(), "scan.ply", std::move(options)), mirror_(document_) {}

  void act() {
    switch (actions_.below(10)) {
      case 0:
        expectMoved(document_.undo(), position_ > 0, -1);
        break;
      case 1:
        expectMoved(document_.redo(), position_ + 1 < states_.size(), 1);
        break;
      case 2:
        position_ = actions_.below(static_cast<Index>(states_.size()));
        document_.goTo(position_);
        break;
      case 3:
      case 4:
      case 5:
        stroke();
        break;
      case 6:
        document_.markSaved("scan.ply", document_.revision());
        saved_ = position_;
        break;
      default:
        change();
    }
    check();
  }

  void goThroughEverything() {
    while (document_.undo()) --position_, check();
    ASSERT_EQ(position_, 0u);
    EXPECT_TRUE(identical(document_.points(), startingPoints()));
    while (document_.redo()) ++position_, check();
    EXPECT_EQ(position_ + 1, states_.size());
  }

  const Document& document() const { return document_; }

 private:
  void check() {
    ASSERT_EQ(document_.history().position(), position_);
    ASSERT_EQ(document_.history().size() + 1, states_.size());
    ASSERT_TRUE(identical(document_.points(), states_[position_]));
    ASSERT_EQ(document_.isModified(), saved_ != position_);
    if (actions_.below(3) != 0) return;
    mirror_.follow(document_);
    ASSERT_TRUE(mirror_.shows(document_.points()));
  }

  void expectMoved(bool moved, bool expected, int by) {
    ASSERT_EQ(moved, expected);
    if (moved) position_ += static_cast<std::size_t>(by);
  }

  void append(const PointSet& next) {
    if (saved_ > position_) saved_.reset();
    states_.resize(++position_);
    states_.push_back(next);
  }

  void change() {
    std::vector<Index> removed;
    const PointSet next = actions_.changed(document_.points(), removed);
    Edit edit = difference(document_.points(), next, removed);
    const bool isEntry = !edit.empty();
    document_.commit("Change", std::move(edit));
    if (isEntry) append(next);
  }

  void stroke() {
    const PointSet before = document_.points();
    document_.beginStroke("Stroke");
    ASSERT_FALSE(document_.undo());
    for (Index dabs = actions_.below(4); dabs > 0; --dabs) {
      document_.paint([this](PointSet& points) { return dab(points); });
      if (actions_.below(2) == 0) mirror_.follow(document_);
    }
    const PointSet after = document_.points();
    if (actions_.below(3) == 0) {
      document_.cancelStroke();
      return;
    }
    document_.endStroke({});
    if (!identical(before, after)) append(after);
  }

  std::vector<Edit::Touched> dab(PointSet& points) {
    if (points.attributes().empty() || actions_.below(6) == 0) {
      points.set("painted", std::vector<float>(points.size(), static_cast<float>(actions_.below(9))));
      return {{"painted", nullptr}};
    }
    if (points.size() == 0) return {};
    const std::string name =
        points.attributes()[actions_.below(static_cast<Index>(points.attributes().size()))].name;
    const Index row = actions_.below(points.size()), from = actions_.below(points.size());
    std::visit([&](auto& values) { values[row] = values[from]; }, points.find(name)->column.edit());
    return {{name, std::make_shared<const std::vector<Index>>(1, row)}};
  }

  RandomActions actions_;
  Document document_;
  Mirror mirror_;
  std::vector<PointSet> states_ = {startingPoints()};
  std::size_t position_ = 0;
  std::optional<std::size_t> saved_ = 0;
};

void workAThousandTimes(HistoryOptions options) {
  RandomWork work(11, std::move(options));
  for (int action = 0; action < 1000; ++action) {
    work.act();
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << "action " << action;
  }
  // Where it has wandered back, something to undo.
  for (int action = 0; action < 20; ++action) work.act();
  work.goThroughEverything();
}

TEST(Document, UndoesAThousandRandomActionsBitForBit) {
  workAThousandTimes({});
}

TEST(Document, UndoesThemFromTheDiskToo) {
  const TemporaryFolder folder;
  workAThousandTimes({.memoryCap = 1, .spillFolder = folder.path()});
}

TEST(Document, RefusesWhatDoesNotFitAndChangesNothing) {
  Document document(startingPoints(), "scan.ply");
  PointSet next = document.points();
  next.set("selection", std::vector<std::int32_t>(200, 1));
  const Edit edit = difference(document.points(), next);
  document.beginStroke("Stroke");
  EXPECT_THAT([&] { document.commit("Select", edit); }, ThrowsMessage<InvalidInput>(HasSubstr("a stroke")));
  EXPECT_THROW(document.beginStroke("Stroke"), InvalidInput);
  document.cancelStroke();
  EXPECT_THROW(document.endStroke({}), InvalidInput);
  document.commit("Select", edit);
  PointSet other = document.points();
  other.erase("selection");
  document.commit("Erase", difference(document.points(), other));
  const auto revision = document.revision();
  EXPECT_THROW(document.commit("Select", edit), InvalidInput);
  EXPECT_EQ(document.revision(), revision);
  EXPECT_EQ(document.history().size(), 2u);
}

TEST(Document, APainterThatFailsLeavesTheStrokeToBeCancelled) {
  Document document(startingPoints(), "scan.ply");
  const auto seen = document.revision();
  document.beginStroke("Stroke");
  const auto failing = [](PointSet& points) -> std::vector<Edit::Touched> {
    points.edit<std::int32_t>("selection")[0] = 1;
    throw InvalidInput("the brush broke");
  };
  EXPECT_THROW(document.paint(failing), InvalidInput);
  EXPECT_TRUE(document.changedSince(seen).everything);
  document.cancelStroke();
  EXPECT_TRUE(identical(document.points(), startingPoints()));
}

TEST(Document, ItsRecipeIsWhatIsDone) {
  Document document(startingPoints(), "scan.ply", {.memoryCap = 0, .spillFolder = {}});
  for (const int label : {1, 2, 3, 4}) {
    PointSet next = document.points();
    next.set("selection", std::vector<std::int32_t>(200, label));
    std::optional<Recipe::Step> step;
    if (label != 2) step = Stroke{.attribute = "selection", .value = {double(label)}, .radius = 1};
    document.commit("Select", difference(document.points(), next), step);
  }
  document.undo();
  EXPECT_EQ(document.history().givenUp(), 3u) << "given up entries are still done";
  const auto done = document.recipe();
  EXPECT_EQ(done.leftOut, 1u);
  ASSERT_EQ(done.recipe.steps.size(), 2u);
  EXPECT_EQ(std::get<Stroke>(done.recipe.steps[1]).value[0], 3);
  EXPECT_TRUE(document.takeMessage());
}

TEST(Document, SavingMakesItUnmodifiedWhereTheFileHoldsEverything) {
  const TemporaryFolder folder;
  Document document(startingPoints(), "scan.ply");
  PointSet next = document.points();
  next.set("selection", std::vector<std::int32_t>(200, 7));
  document.commit("Select", difference(document.points(), next));
  EXPECT_TRUE(document.isModified());
  Progress progress;
  EXPECT_FALSE(document.save(folder.path() / "export.off", {}, progress).empty());
  EXPECT_TRUE(document.isModified()) << "the file lacks the selection";
  EXPECT_EQ(document.path(), "scan.ply");
  EXPECT_TRUE(document.save(folder.path() / "saved.ply", {}, progress).empty());
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(document.path(), folder.path() / "saved.ply");
  const auto saved = document.revision();
  document.undo();
  EXPECT_TRUE(document.isModified());
  document.markSaved("other.ply", saved);
  EXPECT_TRUE(document.isModified()) << "what a worker wrote is what was there when it began";
  document.redo();
  EXPECT_FALSE(document.isModified());
}

}  // namespace
}  // namespace stipple
