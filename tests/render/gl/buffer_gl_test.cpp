#include "render/gl/buffer.h"

#include <cstring>
#include <numeric>

#include "tests/support/gl_fixture.h"

namespace stipple {
namespace {

using BufferTest = GlTest;

std::vector<int> intsOf(const std::vector<std::byte>& bytes) {
  std::vector<int> ints(bytes.size() / sizeof(int));
  std::memcpy(ints.data(), bytes.data(), bytes.size());
  return ints;
}

TEST_F(BufferTest, GivesBackWhatWasWrittenInPieces) {
  std::vector<int> numbers((std::size_t{20} << 20) / sizeof(int) + 5);  // more than two pieces
  std::iota(numbers.begin(), numbers.end(), 0);
  gl::Buffer buffer(numbers.size() * sizeof(int));
  buffer.write<int>(0, numbers);
  EXPECT_EQ(intsOf(buffer.read(0, buffer.size())), numbers);
}

TEST_F(BufferTest, AWriteChangesItsRangeOnly) {
  gl::Buffer buffer(6 * sizeof(int));
  buffer.write<int>(0, std::vector<int>{0, 1, 2, 3, 4, 5});
  buffer.write<int>(2 * sizeof(int), std::vector<int>{20, 30});
  EXPECT_EQ(intsOf(buffer.read(0, buffer.size())), (std::vector<int>{0, 1, 20, 30, 4, 5}));
}

TEST_F(BufferTest, MovesKeepTheContents) {
  gl::Buffer first(sizeof(int));
  first.write<int>(0, std::vector<int>{7});
  gl::Buffer second(std::move(first));
  gl::Buffer third(sizeof(int));
  third = std::move(second);
  EXPECT_EQ(intsOf(third.read(0, sizeof(int))), std::vector<int>{7});
}

TEST_F(BufferTest, MoreThanTheCardHasIsSaidInOneSentence) {
  try {
    const gl::Buffer buffer(std::size_t{1} << 60);
    GTEST_SKIP() << "this driver promises any amount of memory";
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("MB"), std::string::npos) << error.what();
  }
  messages_->take();  // the driver's own complaint
}

TEST_F(BufferTest, LimitsAreThoseThatOpenGlGuarantees) {
  EXPECT_GE(gl::largestStorageBlock(), std::size_t{1} << 24);
  EXPECT_LE(gl::storageAlignment(), 256u);
}

}  // namespace
}  // namespace stipple
