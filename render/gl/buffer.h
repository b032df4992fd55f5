#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/gl/object_name.h"

namespace stipple::gl {

void destroyBuffer(unsigned name);

/// Memory on the graphics card, of a fixed size.
class Buffer {
 public:
  Buffer() = default;
  /// Throws IoError where the card has no room for it.
  explicit Buffer(std::size_t bytes);

  std::size_t size() const { return size_; }
  unsigned name() const { return name_.get(); }

  /// In pieces that the driver copies without holding all of them twice.
  void write(std::size_t offset, std::span<const std::byte> bytes);
  template <class T>
  void write(std::size_t offset, std::span<const T> values) {
    write(offset, std::as_bytes(values));
  }
  /// Waits for the card.
  std::vector<std::byte> read(std::size_t offset, std::size_t bytes) const;

  void bindUniform(unsigned slot) const;
  /// `offset` is a multiple of storageAlignment().
  void bindStorage(unsigned slot, std::size_t offset, std::size_t bytes) const;

 private:
  ObjectName<destroyBuffer> name_;
  std::size_t size_ = 0;
};

/// Most bytes that a shader sees of one buffer, and what offsets into it are multiples of.
std::size_t largestStorageBlock();
std::size_t storageAlignment();

}  // namespace stipple::gl
