#pragma once

#include <cstddef>
#include <vector>

#include "render/gl/buffer.h"
#include "render/hierarchy/refit.h"

namespace stipple {

/// All splats of a hierarchy on the graphics card, in chunks that one shader may see as a whole.
class SplatStore {
 public:
  /// `chunkBytes`: at most so many in a buffer, within what the driver allows.
  explicit SplatStore(std::size_t chunkBytes);

  /// Makes room where the number of nodes differs, and copies the nodes of the ranges. Throws IoError where
  /// the card has no room.
  void upload(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed);

  Index nodeCount() const { return nodeCount_; }
  Index nodesPerChunk() const { return nodesPerChunk_; }
  std::size_t chunkCount() const { return chunks_.size(); }
  const gl::Buffer& chunk(std::size_t index) const { return chunks_[index]; }

 private:
  Index nodesPerChunk_ = 0, nodeCount_ = 0;
  std::vector<gl::Buffer> chunks_;
};

/// Nodes to draw, on the graphics card, those of a chunk together and otherwise in their order.
class NodeList {
 public:
  /// Consecutive entries of the list whose nodes lie in one chunk.
  struct Batch {
    std::size_t chunk = 0;
    std::size_t offset = 0;  ///< bytes into the buffer, aligned for binding
    Index count = 0;
  };

  void set(const std::vector<Index>& nodes, const SplatStore& store);

  const std::vector<Batch>& batches() const { return batches_; }
  const gl::Buffer& buffer() const { return buffer_; }

 private:
  gl::Buffer buffer_;
  std::vector<Batch> batches_;
};

}  // namespace stipple
