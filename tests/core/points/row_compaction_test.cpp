#include "core/points/row_compaction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/error.h"

namespace stipple {
namespace {

TEST(RowCompaction, InsertingUndoesRemovingForEverySubsetOfEightRows) {
  std::vector<int> all(8);
  std::iota(all.begin(), all.end(), 100);
  for (unsigned subset = 0; subset < 256; ++subset) {
    std::vector<Index> rows;
    std::vector<int> expectedRest, taken;
    for (Index row = 0; row < 8; ++row) {
      const bool goes = (subset >> row & 1) != 0;
      if (goes) rows.push_back(row);
      (goes ? taken : expectedRest).push_back(all[row]);
    }
    std::vector<int> column = all;
    removeRowsFrom(column, std::span<const Index>(rows));
    EXPECT_EQ(column, expectedRest);
    insertRowsInto(column, std::span<const Index>(rows), taken);
    EXPECT_EQ(column, all);
  }
}

TEST(RowCompaction, RefusesRowsOutOfOrderOrRange) {
  EXPECT_NO_THROW(checkRowsToRemove(std::vector<Index>{0, 2, 4}, 5));
  EXPECT_THROW(checkRowsToRemove(std::vector<Index>{0, 2, 2}, 5), InvalidInput);
  EXPECT_THROW(checkRowsToRemove(std::vector<Index>{3, 2}, 5), InvalidInput);
  EXPECT_THROW(checkRowsToRemove(std::vector<Index>{5}, 5), InvalidInput);
}

}  // namespace
}  // namespace stipple
