#include "tests/repository/walls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The header that a source is for: core/a.cpp -> core/a.h, tests/core/a_test.cpp -> core/a.h.
std::string headerOf(std::string source) {
  if (source.starts_with("tests/") && source.ends_with("_test.cpp")) {
    const std::string tested = source.substr(6, source.size() - 15) + ".h";
    if (repositoryHas(tested)) return tested;
    source.erase(source.size() - 9, 5);  // a header of the tests
  }
  return source.substr(0, source.size() - 4) + ".h";
}

TEST(Walls, StandBetweenAllRooms) {
  const std::vector<SourceFile> sources = readSources();
  ASSERT_GT(sources.size(), 20u);
  for (const SourceFile& file : sources) {
    for (const Include& include : includesOf(file)) EXPECT_EQ(wallBrokenBy(file.path, include), "");
  }
  EXPECT_THAT(findCircle(sources), IsEmpty());
}

TEST(Walls, EveryFileNamesItsOwnHeaderFirst) {
  for (const SourceFile& file : readSources()) {
    if (file.extension() != ".cpp") continue;
    const std::string own = headerOf(file.path);
    const std::vector<Include> includes = includesOf(file);
    if (!repositoryHas(own) || includes.empty()) continue;
    EXPECT_EQ(includes.front().name, own) << "in " << file.path;
  }
}

TEST(Walls, KeepOursApart) {
  const auto broken = [](const char* path, const char* name) {
    return wallBrokenBy(path, {name, true}) != "";
  };
  // Names that exist, from files that need not.
  EXPECT_TRUE(broken("core/points/a.h", "tests/support/test_data.h"));
  EXPECT_TRUE(broken("plugins/api/a.h", "tests/support/test_data.h"));
  EXPECT_TRUE(broken("app/cli/a.cpp", "tests/support/test_data.h"));
  EXPECT_TRUE(broken("app/jobs/a.cpp", "app/plugins/loader.h"));
  EXPECT_TRUE(broken("app/document/a.cpp", "app/jobs/task.h"));
  EXPECT_TRUE(broken("core/points/a.h", "point_set.h")) << "not from the root";
  EXPECT_FALSE(broken("core/points/a.h", "core/points/point_set.h"));
  EXPECT_FALSE(broken("plugins/fairing/a.h", "core/points/point_set.h"));
  EXPECT_FALSE(broken("render/raster/a.h", "core/points/point_set.h"));
  EXPECT_FALSE(broken("app/cli/a.cpp", "core/points/point_set.h"));
  EXPECT_TRUE(broken("app/panels/a.cpp", "app/document/stroke.h"));
  EXPECT_FALSE(broken("app/panels/a.cpp", "render/appearance/colormap.h"));
  EXPECT_FALSE(broken("app/jobs/a.h", "app/document/invocation.h"));
  EXPECT_FALSE(broken("tests/core/a_test.cpp", "tests/support/test_data.h"));
}

TEST(Walls, KeepOthersInTheirPlace) {
  const auto broken = [](const char* path, const char* name) {
    return wallBrokenBy(path, {name, false}) != "";
  };
  EXPECT_TRUE(broken("core/io/a.cpp", "QString"));
  EXPECT_TRUE(broken("app/document/a.h", "QObject"));
  EXPECT_FALSE(broken("app/window/a.h", "QMainWindow"));
  EXPECT_TRUE(broken("render/hierarchy/a.cpp", "epoxy/gl.h"));
  EXPECT_TRUE(broken("app/panels/a.cpp", "GL/gl.h"));
  EXPECT_TRUE(broken("app/panels/a.cpp", "QWidget"));
  EXPECT_TRUE(broken("app/tools/a.cpp", "imgui.h"));
  EXPECT_FALSE(broken("app/panels/a.cpp", "imgui_internal.h"));
  EXPECT_FALSE(broken("render/gl/a.h", "epoxy/gl.h"));
  EXPECT_TRUE(broken("core/geometry/a.h", "nanoflann.hpp"));
  EXPECT_FALSE(broken("core/geometry/a.cpp", "nanoflann.hpp"));
  EXPECT_TRUE(broken("core/geometry/a.h", "CGAL/Delaunay_triangulation_2.h"));
  EXPECT_TRUE(broken("app/document/a.h", "nlohmann/json.hpp"));
  EXPECT_TRUE(broken("core/fem/a.cpp", "tbb/parallel_for.h"));
  EXPECT_FALSE(broken("core/parallel.cpp", "tbb/parallel_for.h"));
  EXPECT_FALSE(broken("core/points/a.h", "vector"));
}

TEST(Walls, FindsRoomsThatNameEachOther) {
  const SourceFile a{"a/x.h", {"#include \"b/y.h\""}}, b{"b/y.cpp", {"  #  include \"c/z.h\" // why"}};
  const SourceFile c{"c/z.h", {"#include <vector>", "#include \"b/w.h\""}};
  EXPECT_THAT(findCircle({a, b}), IsEmpty());
  EXPECT_THAT(findCircle({a, b, c}), ElementsAre("b", "c", "b"));
}

}  // namespace
}  // namespace stipple
