#include "tests/repository/source_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>

namespace stipple {

namespace fs = std::filesystem;

std::string SourceFile::room() const {
  return fs::path(path).parent_path().generic_string();
}

std::string SourceFile::extension() const {
  return fs::path(path).extension().string();
}

SourceFile readFile(const std::string& path) {
  SourceFile file{.path = path, .lines = {}};
  std::ifstream stream(fs::path(STIPPLE_SOURCE_DIR) / path);
  for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
  return file;
}

std::vector<SourceFile> readTree(const std::string& folder, const std::vector<std::string>& endings) {
  const fs::path root = STIPPLE_SOURCE_DIR;
  std::vector<SourceFile> files;
  if (!fs::is_directory(root / folder)) return files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string path = fs::relative(entry.path(), root).generic_string();
    const auto endsThisWay = [&path](const std::string& ending) { return path.ends_with(ending); };
    if (entry.is_regular_file() && std::ranges::any_of(endings, endsThisWay)) files.push_back(readFile(path));
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<SourceFile> readSources() {
  std::vector<SourceFile> sources;
  for (const char* top : {"core", "plugins", "render", "app", "tests"}) {
    for (SourceFile& file : readTree(top, {".h", ".cpp"})) sources.push_back(std::move(file));
  }
  return sources;
}

std::vector<Include> includesOf(const SourceFile& file) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> includes;
  std::smatch match;
  for (const std::string& line : file.lines) {
    if (std::regex_match(line, match, kInclude)) includes.push_back({match[2], match[1] == "\""});
  }
  return includes;
}

bool repositoryHas(const std::string& path) {
  return fs::exists(fs::path(STIPPLE_SOURCE_DIR) / path);
}

}  // namespace stipple
