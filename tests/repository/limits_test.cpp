#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <regex>

#include "tests/repository/source_tree.h"

namespace stipple {
namespace {

constexpr std::size_t kFileLines = 500;
constexpr std::size_t kFunctionLines = 80;  // as in .clang-tidy; most stay far below
constexpr std::size_t kReadmeLines = 30;

/// The first function longer than the limit, as "path:line"; empty where there is none. Relies on the
/// formatting: a function begins with a line at the margin and ends with a brace at the margin.
std::string longFunctionOf(const SourceFile& file) {
  static const std::regex kBetween(R"((#|//|template).*)");
  static const std::regex kNoFunction(R"((namespace|class|struct|union|enum|extern).*|.*(;|= \{))");
  std::optional<std::size_t> begin;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string& line = file.lines[i];
    if (line.empty() || line[0] == ' ' || std::regex_match(line, kBetween)) continue;
    if (line[0] != '}') {
      begin = std::regex_match(line, kNoFunction) ? std::nullopt : std::optional(i);
    } else {
      if (begin && i - *begin + 1 > kFunctionLines) return file.path + ":" + std::to_string(*begin + 1);
      begin.reset();
    }
  }
  return {};
}

TEST(Limits, NoFileIsLongerThanOneIdea) {
  for (const SourceFile& file : readSources()) EXPECT_LE(file.lines.size(), kFileLines) << file.path;
  for (const SourceFile& file : readTree("shaders", {""}))
    EXPECT_LE(file.lines.size(), kFileLines) << file.path;
}

TEST(Limits, NoFunctionIsLong) {
  for (const SourceFile& file : readSources()) EXPECT_EQ(longFunctionOf(file), "");
}

TEST(Limits, SeeALongFunction) {
  SourceFile file{"a.cpp", {"namespace a {", "", "int f(int x,", "      int y) {"}};
  file.lines.resize(file.lines.size() + kFunctionLines - 3, "  ++x;");
  SourceFile within = file;
  within.lines.insert(within.lines.end(), {"}", "", "}  // namespace a"});
  EXPECT_EQ(longFunctionOf(within), "");
  file.lines.insert(file.lines.end(), {"  ++x;", "  ++x;", "}", "", "}  // namespace a"});
  EXPECT_EQ(longFunctionOf(file), "a.cpp:3");
}

TEST(Limits, EveryRoomHasAShortReadme) {
  namespace fs = std::filesystem;
  const fs::path root = STIPPLE_SOURCE_DIR;
  for (const char* top : {"core", "plugins", "render", "app"}) {
    for (const fs::directory_entry& room : fs::directory_iterator(root / top)) {
      if (!room.is_directory()) continue;
      const std::string folder = fs::relative(room.path(), root).generic_string();
      if (readTree(folder, {".cpp"}).empty()) continue;
      const std::size_t lines = readFile(folder + "/README.md").lines.size();
      EXPECT_GT(lines, 0u) << folder << " has no README.md";
      EXPECT_LE(lines, kReadmeLines) << folder;
    }
  }
}

}  // namespace
}  // namespace stipple
