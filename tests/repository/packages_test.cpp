#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/repository/source_tree.h"

namespace stipple {
namespace {

/// A package that Stipple stands on: how CMake finds and links it, and how sources name it.
struct Package {
  std::string found;
  std::string linked;
  std::string included;
};

// Each package joins with the rooms that use it.
const std::vector<Package> kPackages = {
    {"find_package(Eigen3", "Eigen3::Eigen", "Eigen/"},
    {"find_package(nanoflann", "nanoflann::nanoflann", "nanoflann.hpp"},
    {"find_package(CGAL", "CGAL::CGAL", "CGAL/"},
    {"find_package(glm", "glm::glm", "glm/"},
    {"pkg_check_modules(epoxy", "PkgConfig::epoxy", "epoxy/gl.h"},  // OpenGL
    {"pkg_check_modules(imgui", "PkgConfig::imgui", "imgui.h"},
};

// Rooms of the program, without the tests.
std::vector<SourceFile> readRooms(const std::vector<std::string>& endings) {
  std::vector<SourceFile> files;
  for (const char* top : {"core", "plugins", "render", "app"}) {
    for (SourceFile& file : readTree(top, endings)) files.push_back(std::move(file));
  }
  return files;
}

bool anyLineHas(const std::vector<SourceFile>& files, const std::string& text) {
  return std::ranges::any_of(files, [&](const SourceFile& file) {
    return std::ranges::any_of(file.lines, [&](const std::string& line) {
      return line.find(text) < line.find('#');  // not in a comment
    });
  });
}

bool anyIncludes(const std::vector<SourceFile>& files, const std::string& beginning) {
  return std::ranges::any_of(files, [&](const SourceFile& file) {
    const std::vector<Include> includes = includesOf(file);
    return std::ranges::any_of(includes, [&](const Include& i) { return i.name.starts_with(beginning); });
  });
}

TEST(Packages, AreFoundLinkedAndUsed) {
  std::vector<SourceFile> cmake = readRooms({"CMakeLists.txt"});
  const std::vector<SourceFile> sources = readRooms({".h", ".cpp"});
  cmake.push_back(readFile("CMakeLists.txt"));
  for (const Package& package : kPackages) {
    EXPECT_TRUE(anyLineHas(cmake, package.found)) << package.found << " is in no CMakeLists.txt";
    EXPECT_TRUE(anyLineHas(cmake, package.linked)) << package.linked << " is linked nowhere";
    EXPECT_TRUE(anyIncludes(sources, package.included)) << package.included << " is included nowhere";
  }
}

}  // namespace
}  // namespace stipple
