#include "render/gl/vertex_array.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace stipple::gl {

void destroyVertexArray(unsigned name) {
  glDeleteVertexArrays(1, &name);
}

VertexArray::VertexArray() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  name_ = ObjectName<destroyVertexArray>(name);
}

void VertexArray::setAttribute(unsigned location, VertexFormat format, const Buffer& buffer) {
  const GLuint array = name_.get();
  const bool isFloat = format == VertexFormat::kFloat3;
  glEnableVertexArrayAttrib(array, location);
  glVertexArrayAttribBinding(array, location, location);
  glVertexArrayAttribFormat(array, location, isFloat ? 3 : 4, isFloat ? GL_FLOAT : GL_UNSIGNED_BYTE,
                            isFloat ? GL_FALSE : GL_TRUE, 0);
  glVertexArrayVertexBuffer(array, location, buffer.name(), 0, isFloat ? 12 : 4);
}

void VertexArray::setIndices(const Buffer& buffer) {
  glVertexArrayElementBuffer(name_.get(), buffer.name());
}

void VertexArray::bind() const {
  glBindVertexArray(name_.get());
}

void VertexArray::drawIndexed(std::size_t count) const {
  bind();
  // A draw counts indices in a signed 32-bit number.
  constexpr std::size_t kMost = std::size_t{3} << 28;
  for (std::size_t begin = 0; begin < count; begin += kMost) {
    const std::size_t part = std::min(kMost, count - begin);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(begin * sizeof(std::uint32_t)));
  }
}

}  // namespace stipple::gl
