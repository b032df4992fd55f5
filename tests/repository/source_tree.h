#pragma once

#include <string>
#include <vector>

namespace stipple {

/// A text file of the repository.
struct SourceFile {
  std::string path;  ///< from the repository root, with slashes
  std::vector<std::string> lines;

  std::string room() const;       ///< its folder
  std::string extension() const;  ///< with the dot
};

/// What an include line names: "core/error.h" or <vector>.
struct Include {
  std::string name;
  bool quoted = false;
};

/// The file at a path from the root; without lines where there is none.
SourceFile readFile(const std::string& path);

/// Files under a folder whose names end in one of the given ways, sorted by path. Nothing where there is no
/// folder.
std::vector<SourceFile> readTree(const std::string& folder, const std::vector<std::string>& endings);

/// All of our C++: .h and .cpp of every room and of the tests.
std::vector<SourceFile> readSources();

std::vector<Include> includesOf(const SourceFile& file);

/// Whether the repository, or what the build generates, has a file of this path.
bool repositoryHas(const std::string& path);

}  // namespace stipple
