#include "core/io/row_blocks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/io/point_io.h"
#include "tests/support/temporary_folder.h"

namespace stipple {
namespace {

class Fractions : public Progress {
 public:
  void report(double fraction, std::string_view) override { values.push_back(fraction); }
  std::vector<double> values;
};

TEST(RowBlocks, CoverTheRowsInOrderAndReportUpToOne) {
  const TemporaryFolder folder;
  OutputFile file(folder / "a");
  Fractions progress;
  constexpr std::size_t kFirst = 2 * RowBlocks::kRows + 1, kSecond = RowBlocks::kRows;
  RowBlocks rows(file, kFirst + kSecond, progress);
  std::size_t next = 0;
  rows.writeBlocks(kFirst, [&](std::size_t begin, std::size_t end) {
    EXPECT_EQ(begin, next);
    EXPECT_LE(end - begin, RowBlocks::kRows);
    next = end;
  });
  EXPECT_EQ(next, kFirst);
  rows.writeBlocks(0, [](std::size_t, std::size_t) { FAIL() << "there is nothing to write"; });
  TextBuffer text;
  rows.writeLines(kSecond, text, [&](std::size_t) { text.append("x\n"); });
  file.commit();
  EXPECT_EQ(contentOf(folder / "a").size(), 2 * kSecond);
  EXPECT_EQ(progress.values.size(), 4u);
  EXPECT_TRUE(std::ranges::is_sorted(progress.values));
  EXPECT_EQ(progress.values.back(), 1);
}

// Three points and many triangles: stops when a third of the rows are written.
class CancelAfterAThird : public Progress {
 public:
  void report(double fraction, std::string_view) override { fraction_ = fraction; }
  bool cancelled() const override { return fraction_ > 1.0 / 3; }

 private:
  double fraction_ = 0;
};

TEST(RowBlocks, WritingTrianglesCanBeCancelled) {
  PointSet points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  points.setTriangles(std::vector<Triangle>(4 * RowBlocks::kRows, Triangle{0, 1, 2}));
  for (const char* name : {"a.obj", "a.off", "a.ply"}) {
    const TemporaryFolder folder;
    CancelAfterAThird progress;
    EXPECT_THROW(writePoints(folder / name, points, {}, progress), Cancelled) << name;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
}

}  // namespace
}  // namespace stipple
