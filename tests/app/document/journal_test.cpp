#include "app/document/journal.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/app/document/journaled_work.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// A scan at which somebody has worked, all states on the way, and the bytes of the journal.
class JournalTest : public testing::Test {
 protected:
  void work(std::uint32_t edits) {
    writeScan(scan_);
    document_.emplace(openScan(scan_));
    document_->keepJournal(keepNew());
    states_ = {document_->points()};
    for (std::uint32_t number = 1; number <= edits; ++number) {
      editOnce(*document_, number);
      states_.push_back(document_->points());
    }
    journal_->flush();
    bytes_ = contentOf(fileIn(folder_ / "journals"));
  }
  std::unique_ptr<Journal> keepNew() {
    auto journal = std::make_unique<Journal>(folder_ / "journals", describeBase(scan_));
    journal_ = journal.get();
    return journal;
  }
  void leave(const std::string& bytes) {
    std::filesystem::create_directories(folder_ / "left");
    setContent(folder_ / "left" / "a.journal", bytes);
  }
  // How many edits came back; none where nothing was found or it was refused.
  std::optional<std::size_t> recovered() {
    if (findLostWork(folder_ / "left").empty()) return std::nullopt;
    try {
      const Document document = recoverFrom(folder_ / "left");
      const std::size_t edits = document.history().position();
      EXPECT_TRUE(sameValues(document.points(), states_.at(edits)));
      return edits;
    } catch (const InvalidInput&) {
      return std::nullopt;
    }
  }

  TemporaryFolder folder_;
  std::filesystem::path scan_ = folder_ / "scan.ply";
  std::optional<Document> document_;
  Journal* journal_ = nullptr;
  std::vector<PointSet> states_;
  std::string bytes_;
};

TEST_F(JournalTest, EveryTruncationLeavesTheCompleteRecords) {
  work(6);
  std::size_t last = 0;
  for (std::size_t length = 0; length <= bytes_.size(); ++length) {
    leave(bytes_.substr(0, length));
    const std::size_t edits = recovered().value_or(0);
    ASSERT_TRUE(edits == last || edits == last + 1) << length;
    last = edits;
  }
  EXPECT_EQ(last, 6u);
}

TEST_F(JournalTest, FlippedBytesLeaveTheRecordsBefore) {
  work(6);
  for (std::size_t at = 0; at < bytes_.size(); at += 3) {
    std::string flipped = bytes_;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
    leave(flipped);
    ASSERT_LT(recovered().value_or(0), 6u) << at;
  }
}

TEST_F(JournalTest, IsLockedWhileItLivesAndGoesWithIt) {
  work(2);
  EXPECT_THAT(findLostWork(folder_ / "journals"), IsEmpty());
  EXPECT_FALSE(std::filesystem::is_empty(folder_ / "journals")) << "nor was it removed";
  document_.reset();
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "journals"));
  EXPECT_THAT(findLostWork(folder_ / "nowhere"), IsEmpty());
}

TEST_F(JournalTest, WhatHoldsNoWorkIsRemoved) {
  work(0);
  leave(bytes_);
  setContent(folder_ / "left" / "b.journal", "nonsense");
  setContent(folder_ / "left" / "notes.txt", "not ours");
  EXPECT_THAT(findLostWork(folder_ / "left"), IsEmpty());
  EXPECT_EQ(fileIn(folder_ / "left").filename(), "notes.txt");
}

TEST_F(JournalTest, TellsWhatItIsAbout) {
  work(3);
  document_->undo();
  journal_->flush();
  copyJournal(folder_ / "journals", folder_ / "left");
  const auto lost = findLostWork(folder_ / "left");
  ASSERT_THAT(lost, SizeIs(1));
  EXPECT_EQ(lost[0].base, describeBase(scan_));
  EXPECT_EQ(lost[0].entries, 3u);
  EXPECT_GT(lost[0].modified, 0);
}

TEST_F(JournalTest, TakesNothingFromTwoLivingPrograms) {
  work(2);
  Document other = openScan(scan_);
  other.keepJournal(std::make_unique<Journal>(folder_ / "journals", describeBase(scan_)));
  editOnce(other, 1);
  EXPECT_THAT(findLostWork(folder_ / "journals"), IsEmpty());
}

TEST_F(JournalTest, SaysSoWhereItCannotBeWritten) {
  const auto file = folder_ / "file";
  setContent(file, "not a folder");
  writeScan(scan_);
  EXPECT_THROW(Journal(file, describeBase(scan_)), IoError);
  EXPECT_THROW(describeBase(folder_ / "missing.ply"), IoError);
  work(1);
  std::filesystem::remove_all(folder_ / "journals");
  setContent(folder_ / "journals", "the folder is gone");
  journal_->restart(describeBase(scan_));
  journal_->flush();
  EXPECT_THAT(document_->takeMessage().value(), HasSubstr("no longer saved against a crash"));
  EXPECT_FALSE(document_->takeMessage()) << "once";
  editOnce(*document_, 2);
}

// Works until it is killed.
[[noreturn]] void workForever(const std::filesystem::path& folder, const PointSet& points) {
  Document document(points, folder / "scan.ply");
  document.keepJournal(std::make_unique<Journal>(folder / "journals", describeBase(folder / "scan.ply")));
  for (std::uint32_t number = 1;; ++number) editOnce(document, number);
}

// The journal of a child, once it has grown so long. It may be at any byte.
void waitForJournal(const std::filesystem::path& folder, std::uintmax_t bytes) {
  std::error_code error;
  for (int wait = 0; wait < 30000; ++wait) {
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
      if (entry.file_size(error) > bytes) return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(JournalOfAKilledProgram, LeavesAPrefixOfTheWork) {
  for (const std::uintmax_t bytes : {10'000u, 100'000u, 1'000'000u}) {
    const TemporaryFolder folder;
    writeScan(folder / "scan.ply", 2000);
    const PointSet points = openScan(folder / "scan.ply").points();
    const pid_t child = ::fork();
    if (child == 0) workForever(folder.path(), points);
    waitForJournal(folder / "journals", bytes);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ASSERT_THAT(findLostWork(folder / "journals"), SizeIs(1));
    Document recovered = recoverFrom(folder / "journals");
    EXPECT_GT(recovered.history().position(), 0u);
    Document again = openScan(folder / "scan.ply");
    for (std::uint32_t number = 1; number <= recovered.history().position(); ++number)
      editOnce(again, number);
    EXPECT_TRUE(sameValues(recovered.points(), again.points()));
    while (recovered.undo()) {
    }
    EXPECT_TRUE(sameValues(recovered.points(), points));
  }
}

}  // namespace
}  // namespace stipple
