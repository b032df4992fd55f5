#include "render/gl/debug_messages.h"

#include <epoxy/gl.h>

#include <utility>

namespace stipple::gl {

namespace {

bool isComplaint(GLenum type, GLenum severity) {
  return type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
         severity == GL_DEBUG_SEVERITY_HIGH;
}

void GLAPIENTRY collect(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                        const void* user) {
  if (!isComplaint(type, severity)) return;
  auto* messages = static_cast<DebugMessages*>(const_cast<void*>(user));
  messages->add(length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length)));
}

}  // namespace

DebugMessages::DebugMessages() {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(collect, this);
}

DebugMessages::~DebugMessages() {
  glDebugMessageCallback(nullptr, nullptr);
}

std::vector<std::string> DebugMessages::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(messages_, {});
}

void DebugMessages::add(std::string message) {
  const std::scoped_lock lock(mutex_);
  messages_.push_back(std::move(message));
}

void forgetErrors() {
  // A lost context reports its loss without end.
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) continue;
}

}  // namespace stipple::gl
