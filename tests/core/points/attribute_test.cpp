#include "core/points/attribute.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <optional>
#include <set>
#include <thread>

namespace stipple {
namespace {

TEST(Column, TellsItsTypeAndSize) {
  EXPECT_EQ(Column(std::vector<float>(1)).type(), AttributeType::kFloat);
  EXPECT_EQ(Column(std::vector<double>(1)).type(), AttributeType::kDouble);
  EXPECT_EQ(Column(std::vector<std::int32_t>(1)).type(), AttributeType::kInt);
  EXPECT_EQ(Column(std::vector<std::uint32_t>(1)).type(), AttributeType::kUint);
  EXPECT_EQ(Column(std::vector<Eigen::Vector3f>(1)).type(), AttributeType::kVector3);
  EXPECT_EQ(Column(std::vector<Rgba8>(7)).type(), AttributeType::kColor);
  EXPECT_EQ(Column(std::vector<Rgba8>(7)).size(), 7u);
}

TEST(Column, NamesItsTypesAsScriptsKnowThem) {
  EXPECT_STREQ(nameOf(AttributeType::kFloat), "float");
  EXPECT_STREQ(nameOf(AttributeType::kDouble), "double");
  EXPECT_STREQ(nameOf(AttributeType::kInt), "int");
  EXPECT_STREQ(nameOf(AttributeType::kUint), "uint");
  EXPECT_STREQ(nameOf(AttributeType::kVector3), "vector3");
  EXPECT_STREQ(nameOf(AttributeType::kColor), "color");
}

TEST(Column, RenewsItsIdentityOnEveryWriteAccess) {
  Column column(std::vector<float>{1, 2});
  std::set<ColumnId> ids = {column.id()};
  for (int write = 0; write < 10; ++write) {
    column.editView<float>()[0] = 1;
    EXPECT_TRUE(ids.insert(column.id()).second) << "the identity was used before";
  }
}

TEST(Column, IsWrittenInPlaceWhereNobodyShares) {
  Column column(std::vector<float>{1, 2});
  const float* values = column.view<float>().data();
  { const Column snapshot = column; }
  column.editView<float>()[0] = 5;
  EXPECT_EQ(column.view<float>().data(), values);
}

TEST(Column, MayBeWrittenOnceASnapshotOnAnotherThreadIsGone) {
  constexpr int kSize = 1000;
  for (int round = 0; round < 100; ++round) {
    Column column(std::vector<std::int32_t>(kSize, 1));
    std::optional<Column> snapshot = column;
    std::atomic<bool> gone{false};
    int sum = 0;
    std::thread reader([&] {
      for (const std::int32_t value : snapshot->view<std::int32_t>()) sum += value;
      snapshot.reset();
      gone.store(true, std::memory_order_relaxed);  // says nothing of memory: that is up to the column
    });
    while (!gone.load(std::memory_order_relaxed)) std::this_thread::yield();
    for (std::int32_t& value : column.editView<std::int32_t>()) value = 2;
    reader.join();
    EXPECT_EQ(sum, kSize);
  }
}

TEST(SameBits, ComparesBitsNotNumbers) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  using Floats = std::vector<float>;
  EXPECT_TRUE(sameBits(Floats{1, kNan}, Floats{1, kNan}));
  EXPECT_FALSE(sameBits(Floats{0.f}, Floats{-0.f}));
  EXPECT_FALSE(sameBits(Floats{1}, Floats{1, 2}));
  EXPECT_FALSE(sameBits(Floats{0}, std::vector<std::int32_t>{0}));
  EXPECT_TRUE(sameBits(Floats{}, Floats{}));
}

}  // namespace
}  // namespace stipple
