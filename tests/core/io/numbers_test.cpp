#include "core/io/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "core/io/input_file.h"
#include "core/io/text_buffer.h"

namespace stipple {
namespace {

double parsed(const std::string& text) {
  double value = 0;
  EXPECT_TRUE(toNumber(text, value)) << text;
  return value;
}

TEST(Numbers, SpellingsOfNumbers) {
  EXPECT_EQ(parsed("+1.5e3"), 1500);
  EXPECT_EQ(parsed("-.5"), -0.5);
  EXPECT_EQ(parsed("1e-400"), 0);
  EXPECT_TRUE(std::isinf(parsed("1e400")));
  EXPECT_TRUE(std::isnan(parsed("nan")));
  EXPECT_TRUE(std::isnan(parsed("-nan(ind)")));
  EXPECT_TRUE(std::isnan(parsed("-1.#IND")));
  EXPECT_EQ(parsed("-1.#INF"), -INFINITY);
  double value = 0;
  for (const char* word : {"", "x", "1x", "1.2.3", "--1", "0x10"})
    EXPECT_FALSE(toNumber(word, value)) << word;
}

TEST(Numbers, WordsAndCounts) {
  std::string_view text = " a,b\t;c ";
  EXPECT_EQ(takeWord(text, isSeparator), "a");
  EXPECT_EQ(takeWord(text, isSeparator), "b");
  EXPECT_EQ(takeWord(text, isSeparator), "c");
  EXPECT_EQ(takeWord(text, isSeparator), "");
  std::uint64_t count = 0;
  EXPECT_TRUE(toCount("18446744073709551615", count));
  EXPECT_FALSE(toCount("18446744073709551616", count));
  EXPECT_FALSE(toCount("-1", count));
  EXPECT_FALSE(toCount("1.0", count));
}

TEST(Numbers, ShortestDigits) {
  TextBuffer text;
  text.append(0.1F).append(' ').append(0.1).append(' ').append(-0.0F).append(' ').append(
      std::uint32_t{4294967295u});
  EXPECT_EQ(text.view(), "0.1 0.1 -0 4294967295");
}

TEST(LineReader, LinesLongerThanTheWindowAndWithoutAnEnd) {
  const std::string longLine(3000000, 'a');
  const std::string content = "x\r\n\n" + longLine + "\nlast";
  const InputFile file("a", std::as_bytes(std::span(content.data(), content.size())));
  LineReader lines(file);
  std::string_view line;
  ASSERT_TRUE(lines.next(line));
  EXPECT_EQ(line, "x");
  EXPECT_EQ(lines.offset(), 3u);
  ASSERT_TRUE(lines.next(line));
  EXPECT_EQ(line, "");
  ASSERT_TRUE(lines.next(line));
  EXPECT_TRUE(line == longLine);
  ASSERT_TRUE(lines.next(line));
  EXPECT_EQ(line, "last");
  EXPECT_EQ(lines.number(), 4u);
  EXPECT_FALSE(lines.next(line));
}

TEST(LineReader, SkipsAByteOrderMarkAndTakesCrForTheEndOfLines) {
  const auto linesOf = [](std::string_view content) {
    const InputFile file("a", std::as_bytes(std::span(content.data(), content.size())));
    LineReader lines(file);
    std::vector<std::string> found;
    for (std::string_view line; lines.next(line);) found.emplace_back(line);
    return found;
  };
  EXPECT_EQ(linesOf("\xEF\xBB\xBF"
                    "x\ny"),
            (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(linesOf("x\ry\r\rz"), (std::vector<std::string>{"x", "y", "", "z"}));
  EXPECT_EQ(linesOf("x\ry\n"), (std::vector<std::string>{"x\ry"}));
  EXPECT_EQ(linesOf("\xEF\xBB\xBF"), std::vector<std::string>{});
}

TEST(ByteCursor, TakesAcrossWindowsAndStopsAtTheEnd) {
  std::string content(3000000, '\0');
  for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>(i * 7 % 251);
  const InputFile file("a", std::as_bytes(std::span(content.data(), content.size())));
  ByteCursor cursor(file, 1);
  std::size_t at = 1;
  for (std::size_t count : {3u, 1048575u, 10u, 1500000u}) {
    const std::byte* bytes = cursor.take(count);
    ASSERT_NE(bytes, nullptr);
    EXPECT_EQ(std::memcmp(bytes, content.data() + at, count), 0);
    at += count;
  }
  EXPECT_TRUE(cursor.skip(400000));
  EXPECT_EQ(cursor.offset(), at + 400000);
  EXPECT_EQ(cursor.take(cursor.remaining() + 1), nullptr);
  EXPECT_FALSE(cursor.skip(cursor.remaining() + 1));
  EXPECT_NE(cursor.take(cursor.remaining()), nullptr);
  EXPECT_EQ(cursor.remaining(), 0u);
}

}  // namespace
}  // namespace stipple
