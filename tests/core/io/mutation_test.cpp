// Damaged files: whatever happens to the bytes, a reader returns points or throws an Error, within memory
// that the size of the file bounds.
#include <gtest/gtest.h>

#include <random>

#include "tests/core/io/allocation_meter.h"
#include "tests/core/io/read_from_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

std::string flipBytes(std::string content, std::mt19937& random) {
  for (auto flips = 1 + random() % 8; flips > 0; --flips)
    content[random() % content.size()] = static_cast<char>(random());
  return content;
}

std::string flipBytesOfTheHeader(std::string content, std::mt19937& random) {
  const std::size_t header = std::min<std::size_t>(content.size(), 512);
  for (auto flips = 1 + random() % 4; flips > 0; --flips)
    content[random() % header] = static_cast<char>(random());
  return content;
}

std::string truncate(std::string content, std::mt19937& random) {
  return content.substr(0, random() % content.size());
}

// Puts digits into a number, so that counts and indices grow.
std::string inflateNumber(std::string content, std::mt19937& random) {
  const std::size_t from = random() % std::min<std::size_t>(content.size(), 1024);
  const std::size_t digit = content.find_first_of("123456789", from);
  return digit == std::string::npos ? content : content.insert(digit, random() % 2 ? "4294967295" : "99");
}

std::string overwriteWithOnes(std::string content, std::mt19937& random) {
  const std::size_t at = random() % content.size();
  return content.replace(at, std::min<std::size_t>(4, content.size() - at), "\xff\xff\xff\x7f");
}

std::string repeatAPart(std::string content, std::mt19937& random) {
  const std::size_t from = random() % content.size();
  return content.insert(random() % content.size(), content.substr(from, random() % 200));
}

void expectPointsOrError(const std::string& name, const std::string& content) {
  resetPeakAllocatedBytes();
  const std::size_t before = allocatedBytes();
  try {
    const ReadResult result = readFromText(name, content);
    ASSERT_GT(result.points.size(), 0u);
    for (const Triangle& triangle : result.points.triangles()) {
      for (const Index corner : triangle) ASSERT_LT(corner, result.points.size());
    }
    for (const Eigen::Vector3f& position : result.points.positions()) ASSERT_TRUE(position.allFinite());
  } catch (const Error& error) {
    ASSERT_EQ(std::string(error.what()).substr(0, name.size() + 2), name + ": ");
  }
  // A window for reading, a block of rows, and columns that are wider than the text or bytes they come from.
  ASSERT_GT(peakAllocatedBytes(), before);
  ASSERT_LT(peakAllocatedBytes() - before, 8 * kMegabyte + 100 * content.size());
}

class Mutations : public testing::TestWithParam<const char*> {};

TEST_P(Mutations, EndInPointsOrInAnError) {
  STIPPLE_NEEDS_TEST_DATA();
  const std::filesystem::path path = testData(GetParam());
  std::string content = contentOf(path);
  if (content.size() > 20000) content.resize(20000);  // the begin of large files, cut off by itself
  const std::string name = "damaged" + path.extension().string();
  std::mt19937 random(20240229);
  using Mutation = std::string (*)(std::string, std::mt19937&);
  for (const Mutation mutate :
       {flipBytes, flipBytesOfTheHeader, truncate, inflateNumber, overwriteWithOnes, repeatAPart}) {
    for (int round = 0; round < 1000; ++round) {
      ASSERT_NO_FATAL_FAILURE(expectPointsOrError(name, mutate(content, random))) << "round " << round;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RealFiles, Mutations,
                         testing::Values("formats/platonic_shelf.ply", "formats/platonic_shelf_ascii.ply",
                                         "formats/platonic_shelf_big_endian.ply",
                                         "formats/icosahedron_ascii.ply", "smooth/bunny_tristrips.ply",
                                         "noisy/lato000_rangemap.ply",
                                         "formats/ripple_cloudcompare_binary.ply",
                                         "formats/chameleon4k_surfels.pts", "formats/leica_xyzirgb.pts",
                                         "formats/ripple.ptx", "formats/points_agisoft.xyz",
                                         "open/hemisphere.off", "cc0/spot/spot_control_mesh.obj"),
                         [](const auto& entry) {
                           std::string name = entry.param;
                           std::ranges::replace_if(
                               name, [](unsigned char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

}  // namespace
}  // namespace stipple
