#include "render/gl/buffer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "core/error.h"
#include "render/gl/debug_messages.h"

namespace stipple::gl {

namespace {

constexpr std::size_t kPiece = std::size_t{8} << 20;  // bytes

std::size_t limitOf(GLenum name) {
  GLint64 limit = 0;
  glGetInteger64v(name, &limit);
  return static_cast<std::size_t>(limit);
}

}  // namespace

void destroyBuffer(unsigned name) {
  glDeleteBuffers(1, &name);
}

Buffer::Buffer(std::size_t bytes) : size_(bytes) {
  assert(bytes > 0);
  GLuint name = 0;
  glCreateBuffers(1, &name);
  name_ = ObjectName<destroyBuffer>(name);
  forgetErrors();
  glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_STORAGE_BIT);
  if (glGetError() == GL_OUT_OF_MEMORY) {
    throw IoError(fmt::format("the graphics card has no {:.0f} MB left for a buffer",
                              static_cast<double>(bytes) / 1e6));
  }
}

void Buffer::write(std::size_t offset, std::span<const std::byte> bytes) {
  assert(offset + bytes.size() <= size_);
  for (std::size_t begin = 0; begin < bytes.size(); begin += kPiece) {
    const std::size_t length = std::min(kPiece, bytes.size() - begin);
    glNamedBufferSubData(name(), static_cast<GLintptr>(offset + begin), static_cast<GLsizeiptr>(length),
                         bytes.data() + begin);
  }
}

std::vector<std::byte> Buffer::read(std::size_t offset, std::size_t bytes) const {
  assert(offset + bytes <= size_);
  std::vector<std::byte> result(bytes);
  glGetNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                          result.data());
  return result;
}

void Buffer::bindUniform(unsigned slot) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, slot, name());
}

void Buffer::bindStorage(unsigned slot, std::size_t offset, std::size_t bytes) const {
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, slot, name(), static_cast<GLintptr>(offset),
                    static_cast<GLsizeiptr>(bytes));
}

std::size_t largestStorageBlock() {
  return limitOf(GL_MAX_SHADER_STORAGE_BLOCK_SIZE);
}

std::size_t storageAlignment() {
  return limitOf(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT);
}

}  // namespace stipple::gl
