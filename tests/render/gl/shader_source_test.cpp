#include "render/gl/shader_source.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.h"

namespace stipple::gl {
namespace {

namespace fs = std::filesystem;

class ShaderSourceTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  fs::path folder_ =
      fs::path(::testing::TempDir()) / ("stipple_shader_source_test_" + std::to_string(getpid()));
};

TEST_F(ShaderSourceTest, PutsEachIncludeInPlaceOnce) {
  write("a.frag", "#version 450 core\n#include \"b.glsl\"\n#include \"c.glsl\"\nvoid main() {}\n");
  write("b.glsl", "#include \"c.glsl\"\nfloat b;\n");
  write("c.glsl", "float c;\n");
  const ShaderSource source = readShader(folder_, "a.frag");
  EXPECT_EQ(source.files, (std::vector<std::string>{"a.frag", "b.glsl", "c.glsl"}));
  EXPECT_EQ(source.text,
            "#version 450 core\n#line 1 1\n#line 1 2\nfloat c;\n#line 2 1\nfloat b;\n#line 3 0\n#line 4 0\n"
            "void main() {}\n");
}

TEST_F(ShaderSourceTest, NamesTheFileThatIsMissing) {
  write("a.frag", "#include \"missing.glsl\"\n");
  try {
    readShader(folder_, "a.frag");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_NE(std::string(error.what()).find("missing.glsl"), std::string::npos) << error.what();
  }
}

TEST(ShaderMessages, NameFilesInAllDialects) {
  const std::vector<std::string> files = {"a.frag", "b.glsl"};
  EXPECT_EQ(nameFiles("1:12(5): error: no", files), "b.glsl:12: error: no");           // Mesa
  EXPECT_EQ(nameFiles("0(3) : error C0000: no", files), "a.frag:3: error C0000: no");  // NVIDIA
  EXPECT_EQ(nameFiles("ERROR: 1:7: no\nit fails", files), "b.glsl:7: no\nit fails");   // AMD, Apple
  EXPECT_EQ(nameFiles("9:1: error: unknown file", files), "9:1: error: unknown file");
}

TEST(ShaderFolder, HoldsTheShadersOfTheRepository) {
  for (const fs::directory_entry& file : fs::directory_iterator(fs::path(STIPPLE_SOURCE_DIR) / "shaders")) {
    const std::string ending = file.path().extension();
    if (ending != ".vert" && ending != ".frag" && ending != ".glsl") continue;
    EXPECT_TRUE(fs::exists(shaderFolder() / file.path().filename())) << file.path();
  }
}

}  // namespace
}  // namespace stipple::gl
