#include "render/gl/program.h"

#include <filesystem>
#include <fstream>

#include "render/gl/shader_source.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/temporary_folder.h"

namespace stipple {
namespace {

namespace fs = std::filesystem;

class ProgramTest : public GlTest {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  // What the driver says to the two files.
  std::string complaint() {
    std::string what;
    try {
      const gl::Program program(folder_, "a.vert", "a.frag");
    } catch (const IoError& error) {
      what = error.what();
    }
    messages_->take();  // the driver may say it there as well
    return what;
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

constexpr const char* kVertex = "#version 450 core\nvoid main() { gl_Position = vec4(0); }\n";

TEST_F(ProgramTest, ErrorsNameFileAndLine) {
  write("a.vert", kVertex);
  write("a.frag", "#version 450 core\n#include \"part.glsl\"\nvoid main() {}\n");
  write("part.glsl", "// first\n\nfloat broken() { return nothing; }\n");
  EXPECT_NE(complaint().find("part.glsl:3: "), std::string::npos) << complaint();
  write("part.glsl", "float whole() { return 1; }\n");
  write("a.frag", "#version 450 core\n#include \"part.glsl\"\nvoid main() { broken(); }\n");
  EXPECT_NE(complaint().find("a.frag:3: "), std::string::npos) << complaint();
}

TEST_F(ProgramTest, LinkErrorsNameBothFiles) {
  write("a.vert", kVertex);
  write("a.frag",
        "#version 450 core\nflat in int given;\nout vec4 color;\nvoid main() { color = vec4(given); }\n");
  const std::string what = complaint();
  EXPECT_NE(what.find("a.vert"), std::string::npos) << what;
  EXPECT_NE(what.find("given"), std::string::npos) << what;
}

TEST_F(ProgramTest, AMissingFileIsNamed) {
  write("a.vert", kVertex);
  EXPECT_NE(complaint().find("a.frag"), std::string::npos);
}

}  // namespace
}  // namespace stipple
