#include "app/document/change_log.h"

#include <gmock/gmock.h>

#include <numeric>

namespace stipple {
namespace {

using testing::ElementsAre;

DocumentChange dab(std::string name, std::vector<Index> rows) {
  return {.columns = {{std::move(name), std::make_shared<const std::vector<Index>>(std::move(rows))}}};
}

TEST(ChangeLog, UnitesWhatHappenedSince) {
  ChangeLog log;
  const auto start = log.revision();
  log.add(dab("color", {1, 5}));
  const auto later = log.revision();
  log.add(dab("color", {2, 5}));
  log.add({.triangles = true, .columns = {{"mask", nullptr}}});
  const DocumentChange all = log.since(start);
  EXPECT_FALSE(all.everything);
  EXPECT_TRUE(all.triangles);
  ASSERT_EQ(all.columns.size(), 2u);
  EXPECT_THAT(*all.columns[0].rows, ElementsAre(1, 2, 5));
  EXPECT_EQ(all.columns[1].rows, nullptr);
  EXPECT_THAT(*log.since(later).columns[0].rows, ElementsAre(2, 5));
  EXPECT_TRUE(log.since(log.revision()).columns.empty());
  log.add({.everything = true});
  EXPECT_TRUE(log.since(later).everything);
}

TEST(ChangeLog, ForgetsWhatIsLongAgo) {
  ChangeLog log;
  const auto start = log.revision();
  for (Index i = 0; i < 5000; ++i) log.add(dab("color", {i}));
  EXPECT_TRUE(log.since(start).everything);
  EXPECT_THAT(*log.since(log.revision() - 2).columns[0].rows, ElementsAre(4998, 4999));
}

TEST(ChangeLog, ListsNoMoreRowsThanAreWorthListing) {
  ChangeLog log;
  std::vector<Index> many(2'000'000);
  std::iota(many.begin(), many.end(), 0u);
  log.add(dab("color", many));
  EXPECT_EQ(log.since(log.revision() - 1).columns[0].rows, nullptr);
}

}  // namespace
}  // namespace stipple
