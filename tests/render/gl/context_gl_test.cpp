#include "render/gl/context.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "render/gl/egl_context.h"

namespace stipple::gl {
namespace {

TEST(Context, NothingIsCurrentBeforeOneIsMade) {
  EXPECT_FALSE(currentContext());
}

TEST(Context, OneWithoutAWindowIsCurrentWhileItLives) {
  try {
    const EglContext context;
    const auto current = currentContext();
    ASSERT_TRUE(current);
    EXPECT_GE(current->version, 45);
    EXPECT_EQ(current->renderer, context.renderer());
    EXPECT_FALSE(context.renderer().empty());
  } catch (const IoError& error) {
    GTEST_SKIP() << error.what();
  }
  EXPECT_FALSE(currentContext());
}

TEST(Context, SoftwareIsToldByItsName) {
  EXPECT_TRUE((Context{45, "llvmpipe (LLVM 15.0.6, 256 bits)"}.isSoftware()));
  EXPECT_TRUE((Context{45, "softpipe"}.isSoftware()));
  EXPECT_FALSE((Context{46, "NVIDIA H100/PCIe/SSE2"}.isSoftware()));
}

}  // namespace
}  // namespace stipple::gl
