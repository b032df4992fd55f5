#include "app/document/history.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "tests/support/identical.h"
#include "tests/support/temporary_folder.h"

namespace stipple {
namespace {

using testing::HasSubstr;

// A history of whole-model edits: edit e sets every height to e + 1.
struct Work {
  PointSet points;
  History history;

  explicit Work(HistoryOptions options, Index size = 1000)
      : points(std::vector<Eigen::Vector3f>(size, Eigen::Vector3f::Zero())), history(std::move(options)) {
    points.set("height", std::vector<float>(size, 0));
  }
  void edit() {
    PointSet next = points;
    next.set("height", std::vector<float>(points.size(), height() + 1));
    HistoryEntry entry{.title = "Raise", .edit = difference(points, next)};
    entry.edit.apply(points);
    history.push(std::move(entry));
  }
  float height() const { return points.values<float>("height")[points.size() - 1]; }
};

constexpr std::size_t kEditBytes = 4000;  // of heights; an edit takes a little more

TEST(History, UndoesAndRedoesInOrder) {
  Work work({});
  for (int i = 0; i < 3; ++i) work.edit();
  EXPECT_FALSE(work.history.canRedo());
  EXPECT_FALSE(work.history.undo(work.points).isApplied());
  work.history.undo(work.points);
  EXPECT_EQ(work.height(), 1);
  EXPECT_TRUE(work.history.redo(work.points).isApplied());
  EXPECT_EQ(work.height(), 2);
  EXPECT_EQ(work.history.position(), 2u);
  work.edit();
  EXPECT_EQ(work.history.size(), 3u) << "what was undone is dropped";
  EXPECT_EQ(work.history.title(2), "Raise");
}

TEST(History, StaysBelowTheCapAndUndoesFromTheDisk) {
  const TemporaryFolder folder;
  constexpr std::size_t kCap = 10 * kEditBytes;
  Work work({.memoryCap = kCap, .spillFolder = folder.path() / "new" / "folder"});
  for (int i = 0; i < 200; ++i) {
    work.edit();
    ASSERT_LE(work.history.memoryBytes(), kCap);
  }
  EXPECT_GT(work.history.spilledBytes(), 190 * kEditBytes);
  EXPECT_EQ(work.history.edit(0).isApplied(), true) << "a spilled edit can be looked at";
  for (int i = 200; i > 0; --i) {
    ASSERT_EQ(work.height(), i);
    work.history.undo(work.points);
    ASSERT_LE(work.history.memoryBytes(), kCap);
  }
  EXPECT_EQ(work.height(), 0);
  while (work.history.canRedo()) work.history.redo(work.points);
  EXPECT_EQ(work.height(), 200);
  EXPECT_EQ(work.history.givenUp(), 0u);
  EXPECT_FALSE(work.history.takeMessage());
}

TEST(History, LeavesNothingInTheSpillFolder) {
  const TemporaryFolder folder;
  {
    Work work({.memoryCap = 0, .spillFolder = folder.path()});
    for (int i = 0; i < 5; ++i) work.edit();
    EXPECT_EQ(work.history.memoryBytes(), 0u);
    for (int i = 0; i < 3; ++i) work.history.undo(work.points);
    work.edit();
    EXPECT_LT(work.history.spilledBytes(), 4 * kEditBytes) << "dropped edits give their room back";
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(History, GivesTheOldestUpWhereNothingCanBeSpilled) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "file";
  std::ofstream(file) << "not a folder";
  Work work({.memoryCap = 3 * kEditBytes + 2000, .spillFolder = file});
  for (int i = 0; i < 10; ++i) work.edit();
  EXPECT_EQ(work.history.size(), 3u);
  EXPECT_EQ(work.history.position(), 3u);
  EXPECT_EQ(work.history.givenUp(), 7u);
  EXPECT_EQ(work.history.givenUpSteps().size(), 7u);
  EXPECT_THAT(work.history.takeMessage().value(),
              AllOf(HasSubstr("7 steps of the history"), HasSubstr(file.string())));
  EXPECT_FALSE(work.history.takeMessage()) << "once";
  while (work.history.canUndo()) work.history.undo(work.points);
  EXPECT_EQ(work.height(), 7);
}

TEST(History, KeepsTheNewestWhateverItTakes) {
  Work work({.memoryCap = 1, .spillFolder = {}});
  work.edit();
  work.edit();
  EXPECT_EQ(work.history.size(), 1u);
  work.history.undo(work.points);
  EXPECT_EQ(work.height(), 1);
  work.history.redo(work.points);
  EXPECT_EQ(work.height(), 2);
}

// A disk that takes no more than so many bytes.
class DiskLimit {
 public:
  explicit DiskLimit(std::size_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{.rlim_cur = bytes, .rlim_max = before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~DiskLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_;
  void (*handler_)(int);
};

TEST(History, GivesTheOldestUpWhereTheDiskIsFull) {
  const TemporaryFolder folder;
  Work work({.memoryCap = 2 * kEditBytes + 2000, .spillFolder = folder.path()});
  {
    const DiskLimit limit(5 * kEditBytes + 2000);
    for (int i = 0; i < 20; ++i) work.edit();
  }
  EXPECT_LE(work.history.memoryBytes(), 2 * kEditBytes + 2000);
  EXPECT_GE(work.history.size(), 2u);
  EXPECT_EQ(work.history.size() + work.history.givenUp(), 20u);
  EXPECT_THAT(work.history.takeMessage().value(), HasSubstr("had to be given up"));
  const auto left = static_cast<float>(work.history.size());
  while (work.history.canUndo()) work.history.undo(work.points);
  EXPECT_EQ(work.height(), 20 - left);
  while (work.history.canRedo()) work.history.redo(work.points);
  EXPECT_EQ(work.height(), 20);
}

}  // namespace
}  // namespace stipple
