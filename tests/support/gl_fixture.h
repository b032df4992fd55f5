#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "core/error.h"
#include "render/gl/debug_messages.h"
#include "render/gl/egl_context.h"

namespace stipple {

/// Runs each test in one OpenGL 4.5 context without a window, and fails where the driver complains. Skips,
/// saying why, where the system has no such context.
class GlTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    try {
      context_ = std::make_unique<gl::EglContext>();
    } catch (const IoError& error) {
      whyNot_ = error.what();
    }
  }
  static void TearDownTestSuite() { context_.reset(); }

  void SetUp() override {
    if (!context_) GTEST_SKIP() << whyNot_;
    messages_.emplace();
  }
  void TearDown() override {
    if (!messages_) return;
    for (const std::string& message : messages_->take()) ADD_FAILURE() << message;
    messages_.reset();
  }

  static inline std::unique_ptr<gl::EglContext> context_;
  static inline std::string whyNot_;
  std::optional<gl::DebugMessages> messages_;
};

}  // namespace stipple
