#include "render/splat/splat_store.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace stipple {

namespace {

// Of a draw: short enough for a stop between two of them to come soon.
constexpr Index kBatchNodes = Index{1} << 20;

}  // namespace

SplatStore::SplatStore(std::size_t chunkBytes) {
  const std::size_t bytes = std::min(chunkBytes, gl::largestStorageBlock());
  nodesPerChunk_ = static_cast<Index>(std::max<std::size_t>(bytes / sizeof(Splat), 1));
}

void SplatStore::upload(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed) {
  if (hierarchy.nodeCount() != nodeCount_) {
    chunks_.clear();  // before the new ones: both may not fit
    nodeCount_ = 0;
    for (Index begin = 0; begin < hierarchy.nodeCount();) {
      const Index count = std::min(nodesPerChunk_, hierarchy.nodeCount() - begin);
      chunks_.emplace_back(count * sizeof(Splat));
      begin += count;
    }
    nodeCount_ = hierarchy.nodeCount();
  }
  for (const NodeRange& range : changed) {
    assert(range.begin <= range.end && range.end <= nodeCount_);
    for (Index begin = range.begin; begin < range.end;) {
      const Index chunk = begin / nodesPerChunk_, first = begin % nodesPerChunk_;
      const Index count = std::min(range.end - begin, nodesPerChunk_ - first);
      chunks_[chunk].write<Splat>(first * sizeof(Splat), hierarchy.splats().subspan(begin, count));
      begin += count;
    }
  }
}

void NodeList::set(const std::vector<Index>& nodes, const SplatStore& store) {
  batches_.clear();
  std::vector<Index> counts(store.chunkCount());
  for (const Index node : nodes) ++counts[node / store.nodesPerChunk()];

  // Every chunk's nodes begin where a binding may begin.
  const std::size_t alignment = std::max(gl::storageAlignment() / sizeof(Index), std::size_t{1});
  std::vector<std::size_t> ends;
  std::size_t size = 0;
  for (std::size_t chunk = 0; chunk < counts.size(); ++chunk) {
    ends.push_back(size);
    for (Index done = 0; done < counts[chunk]; done += kBatchNodes) {
      batches_.push_back({.chunk = chunk,
                          .offset = (size + done) * sizeof(Index),
                          .count = std::min(kBatchNodes, counts[chunk] - done)});
    }
    size += (counts[chunk] + alignment - 1) / alignment * alignment;
  }
  if (batches_.empty()) return;

  std::vector<Index> sorted;
  std::span<const Index> entries = nodes;
  if (counts.size() > 1) {
    sorted.resize(size);
    for (const Index node : nodes) sorted[ends[node / store.nodesPerChunk()]++] = node;
    entries = sorted;
  }
  if (buffer_.size() < entries.size_bytes()) {
    buffer_ = gl::Buffer();  // before the new one: both may not fit
    buffer_ = gl::Buffer(entries.size_bytes() + entries.size_bytes() / 4);
  }
  buffer_.write<Index>(0, entries);
}

}  // namespace stipple
