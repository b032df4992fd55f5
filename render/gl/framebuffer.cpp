#include "render/gl/framebuffer.h"

#include <epoxy/gl.h>

#include <cassert>

namespace stipple::gl {

void destroyFramebuffer(unsigned name) {
  glDeleteFramebuffers(1, &name);
}

Framebuffer::Framebuffer(const std::vector<const Texture2D*>& colors, const Texture2D* depth) {
  assert(!colors.empty());
  width_ = colors.front()->width();
  height_ = colors.front()->height();
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  name_ = ObjectName<destroyFramebuffer>(name);
  std::vector<GLenum> attachments;
  for (const Texture2D* color : colors) {
    attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
    glNamedFramebufferTexture(name, attachments.back(), color->name(), 0);
  }
  if (depth) glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth->name(), 0);
  glNamedFramebufferDrawBuffers(name, static_cast<GLsizei>(attachments.size()), attachments.data());
  assert(glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name());
  glViewport(0, 0, width_, height_);
}

void Framebuffer::clearColor(int attachment, const std::array<float, 4>& color) {
  glClearNamedFramebufferfv(name(), GL_COLOR, attachment, color.data());
}

void Framebuffer::clearColor(int attachment, const std::array<std::uint32_t, 4>& color) {
  glClearNamedFramebufferuiv(name(), GL_COLOR, attachment, color.data());
}

void Framebuffer::clearDepth(float depth) {
  glClearNamedFramebufferfv(name(), GL_DEPTH, 0, &depth);
}

CallersTarget::CallersTarget() {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
  glGetIntegerv(GL_VIEWPORT, viewport_.data());
  glGetIntegerv(GL_CLIP_ORIGIN, &clipOrigin_);
  glGetIntegerv(GL_CLIP_DEPTH_MODE, &clipDepth_);
}

CallersTarget::~CallersTarget() {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  glClipControl(static_cast<GLenum>(clipOrigin_), static_cast<GLenum>(clipDepth_));
}

void blitFlipped(const Framebuffer& source, int width, int height, unsigned target) {
  glBlitNamedFramebuffer(source.name(), target, 0, 0, width, height, 0, height, width, 0, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
}

}  // namespace stipple::gl
