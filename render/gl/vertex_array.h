#pragma once

#include <cstddef>
#include <cstdint>

#include "render/gl/buffer.h"
#include "render/gl/object_name.h"

namespace stipple::gl {

void destroyVertexArray(unsigned name);

/// Three floats, or four bytes that stand for [0, 1].
enum class VertexFormat { kFloat3, kUnitByte4 };

/// Where the corners of triangles come from. Without attributes: from the vertex shader alone.
class VertexArray {
 public:
  VertexArray();

  /// Attribute `location` is read from the buffer, which must outlive it, one value after the other.
  void setAttribute(unsigned location, VertexFormat format, const Buffer& buffer);
  /// Of 32-bit indices.
  void setIndices(const Buffer& buffer);
  void bind() const;
  /// The first `count` indices, three a triangle.
  void drawIndexed(std::size_t count) const;

 private:
  ObjectName<destroyVertexArray> name_;
};

}  // namespace stipple::gl
