#include "app/document/recovery.h"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "tests/app/document/journaled_work.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// Somebody works on a scan, and at any time the program may end.
class RecoveryTest : public testing::Test {
 protected:
  RecoveryTest() {
    writeScan(scan_);
    document_.emplace(openScan(scan_));
    auto journal = std::make_unique<Journal>(folder_ / "journals", describeBase(scan_));
    journal_ = journal.get();
    document_->keepJournal(std::move(journal));
  }
  Document crashAndRecover() {
    journal_->flush();
    copyJournal(folder_ / "journals", folder_ / "left");
    return recoverFrom(folder_ / "left");
  }
  void save(const std::string& name) {
    Progress progress;
    ASSERT_TRUE(document_->save(folder_ / name, {}, progress).empty());
  }

  TemporaryFolder folder_;
  std::filesystem::path scan_ = folder_ / "scan.ply";
  std::optional<Document> document_;
  Journal* journal_ = nullptr;
};

TEST_F(RecoveryTest, BringsPointsHistoryAndRecipeBack) {
  for (std::uint32_t number = 1; number <= 6; ++number) editOnce(*document_, number);
  document_->undo();
  document_->undo();
  document_->redo();
  Document recovered = crashAndRecover();
  EXPECT_TRUE(sameValues(recovered.points(), document_->points()));
  EXPECT_EQ(recovered.path(), scan_);
  EXPECT_TRUE(recovered.isModified());
  EXPECT_EQ(recovered.history().size(), 6u);
  EXPECT_EQ(recovered.history().position(), 5u);
  EXPECT_EQ(recovered.history().title(2), "Edit 3");
  EXPECT_EQ(formatRecipe(recovered.recipe().recipe), formatRecipe(document_->recipe().recipe));
  EXPECT_EQ(recovered.recipe().leftOut, 3u);
  while (recovered.undo()) {
  }
  EXPECT_FALSE(recovered.isModified());
  EXPECT_TRUE(sameValues(recovered.points(), openScan(scan_).points()));
}

TEST_F(RecoveryTest, StrokesComeBackWithoutTheCancelledOnes) {
  const auto dab = [](PointSet& points) -> std::vector<Edit::Touched> {
    points.edit<std::int32_t>("label")[3] += 1;
    return {{"label", std::make_shared<const std::vector<Index>>(1, 3)}};
  };
  for (const bool isCancelled : {false, true, false}) {
    document_->beginStroke("Paint");
    document_->paint(dab);
    isCancelled ? document_->cancelStroke() : document_->endStroke({});
  }
  const Document recovered = crashAndRecover();
  EXPECT_EQ(recovered.points().values<std::int32_t>("label")[3], 2);
  EXPECT_EQ(recovered.history().size(), 2u);
}

TEST_F(RecoveryTest, GoesOnInTheSameJournal) {
  for (std::uint32_t number = 1; number <= 3; ++number) editOnce(*document_, number);
  {
    Document recovered = crashAndRecover();
    EXPECT_TRUE(recovered.keepsJournal());
    Progress progress;
    const LostWork same{.journal = fileIn(folder_ / "left"), .base = {}};
    EXPECT_THAT([&] { recoverDocument(same, {}, progress); },
                ThrowsMessage<InvalidInput>(HasSubstr("another program")));
    recovered.undo();
    editOnce(recovered, 8);
    // The program ends once more, when all of it has come to the disk.
    const auto arrived = [&] {
      copyJournal(folder_ / "left", folder_ / "twice");
      return sameValues(recoverFrom(folder_ / "twice").points(), recovered.points());
    };
    int tries = 0;
    while (!arrived() && ++tries < 1000) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_LT(tries, 1000);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "left")) << "a document that ends in order leaves none";
}

TEST_F(RecoveryTest, WorksAcrossSaving) {
  for (std::uint32_t number = 1; number <= 4; ++number) editOnce(*document_, number);
  save("saved.ply");
  editOnce(*document_, 5);
  Document after = crashAndRecover();
  EXPECT_EQ(after.path(), folder_ / "saved.ply");
  EXPECT_TRUE(sameValues(after.points(), document_->points()));
  EXPECT_EQ(after.history().size(), 1u) << "what the file holds is no longer in the journal";
  // Back to before the file was saved.
  for (int i = 0; i < 3; ++i) document_->undo();
  Document before = crashAndRecover();
  EXPECT_TRUE(sameValues(before.points(), document_->points()));
  EXPECT_TRUE(before.isModified());
  before.redo();
  before.redo();
  EXPECT_FALSE(before.isModified());
  EXPECT_TRUE(sameValues(before.points(), openScan(folder_ / "saved.ply").points()));
}

TEST_F(RecoveryTest, WorksAcrossSavingByAWorker) {
  const auto savedLater = [this](const std::string& name, const PointSet& points, std::uint64_t revision) {
    Progress progress;
    writePoints(folder_ / name, points, {}, progress);
    document_->markSaved(folder_ / name, revision);
    const Document recovered = crashAndRecover();
    EXPECT_EQ(recovered.path(), folder_ / name);
    EXPECT_TRUE(sameValues(recovered.points(), document_->points())) << name;
  };
  for (std::uint32_t number = 1; number <= 4; ++number) editOnce(*document_, number);
  PointSet points = document_->points();
  auto revision = document_->revision();
  editOnce(*document_, 5);
  editOnce(*document_, 6);
  savedLater("ahead.ply", points, revision);
  points = document_->points();
  revision = document_->revision();
  for (int i = 0; i < 3; ++i) document_->undo();
  savedLater("behind.ply", points, revision);
  document_->redo();
  EXPECT_TRUE(sameValues(crashAndRecover().points(), document_->points()));
  EXPECT_FALSE(document_->takeMessage());
}

TEST_F(RecoveryTest, FollowsRandomWork) {
  std::mt19937 random(4);
  for (std::uint32_t action = 1; action <= 400; ++action) {
    const auto choice = random() % 20;
    if (choice < 6) {
      document_->undo();
    } else if (choice < 9) {
      document_->redo();
    } else if (choice == 9) {
      save("saved" + std::to_string(action % 2) + ".ply");
    } else {
      editOnce(*document_, action);
    }
    if (action % 10 != 0) continue;
    journal_->flush();
    copyJournal(folder_ / "journals", folder_ / "left");
    if (findLostWork(folder_ / "left").empty()) {
      ASSERT_FALSE(document_->isModified()) << action;
      continue;
    }
    Document recovered = recoverFrom(folder_ / "left");
    ASSERT_TRUE(sameValues(recovered.points(), document_->points())) << action;
    ASSERT_EQ(recovered.isModified(), document_->isModified()) << action;
    while (recovered.undo() && recovered.isModified()) {
    }
  }
  EXPECT_FALSE(document_->takeMessage());
}

TEST_F(RecoveryTest, StepsOfMissingOperatorsAreNoStepsOfTheRecipe) {
  Parameters parameters(std::vector<Parameter>{{.id = "amount", .defaultValue = 2.0}});
  PointSet next = document_->points();
  next.set("label", std::vector<std::int32_t>(next.size(), 9));
  document_->commit("Gone", difference(document_->points(), next), Invocation{"gone", parameters});
  const Document recovered = crashAndRecover();
  EXPECT_EQ(recovered.points().values<std::int32_t>("label")[0], 9);
  EXPECT_EQ(recovered.recipe().leftOut, 1u);
}

TEST_F(RecoveryTest, RefusesAnotherFileInOneSentence) {
  editOnce(*document_, 1);
  journal_->flush();
  copyJournal(folder_ / "journals", folder_ / "left");
  const auto recovering = [this] { recoverFrom(folder_ / "left"); };
  const std::string content = contentOf(scan_);
  setContent(scan_, content + " ");
  EXPECT_THAT(recovering, ThrowsMessage<InvalidInput>(HasSubstr("scan.ply cannot be restored: the file has "
                                                                "changed since")));
  std::filesystem::remove(scan_);
  EXPECT_THAT(recovering, ThrowsMessage<InvalidInput>(HasSubstr("the file is missing")));
}

TEST_F(RecoveryTest, AJournalBeginsWithAFile) {
  Document other = openScan(scan_);
  editOnce(other, 1);
  EXPECT_THROW(other.keepJournal(std::make_unique<Journal>(folder_ / "other", describeBase(scan_))),
               InvalidInput);
  other.undo();
  other.keepJournal(std::make_unique<Journal>(folder_ / "other", describeBase(scan_)));
  EXPECT_TRUE(other.keepsJournal());
  other.redo();
  other.keepJournal(nullptr);
  EXPECT_FALSE(other.keepsJournal());
}

}  // namespace
}  // namespace stipple
