#include "render/splat/splat_store.h"

#include <cstring>

#include "tests/support/gl_fixture.h"
#include "tests/support/splat_scenes.h"

namespace stipple {
namespace {

class SplatStoreTest : public GlTest {
 protected:
  static std::vector<Splat> splatsOf(const SplatStore& store) {
    std::vector<Splat> splats;
    for (std::size_t i = 0; i < store.chunkCount(); ++i) {
      const std::vector<std::byte> bytes = store.chunk(i).read(0, store.chunk(i).size());
      splats.resize(splats.size() + bytes.size() / sizeof(Splat));
      std::memcpy(splats.data() + splats.size() - bytes.size() / sizeof(Splat), bytes.data(), bytes.size());
    }
    return splats;
  }
  // Floats and colors of every splat are compared as they lie in memory.
  static bool areSame(std::span<const Splat> a, std::span<const Splat> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
  }

  static constexpr std::size_t kChunk = 100 * sizeof(Splat) + 7;
};

TEST_F(SplatStoreTest, ChunksTogetherHoldAllNodes) {
  const Hierarchy hierarchy = scenes::hierarchyOf(scenes::sphere(1000));
  SplatStore store(kChunk);
  store.upload(hierarchy, scenes::allNodes(hierarchy));
  EXPECT_EQ(store.chunkCount(), (hierarchy.nodeCount() + 99) / 100);
  EXPECT_TRUE(areSame(splatsOf(store), hierarchy.splats()));
}

TEST_F(SplatStoreTest, RangesChangeTheirNodesOnly) {
  Hierarchy hierarchy = scenes::hierarchyOf(scenes::sphere(1000));
  SplatStore store(kChunk);
  store.upload(hierarchy, scenes::allNodes(hierarchy));
  std::vector<Splat> expected = splatsOf(store);
  for (Splat& splat : hierarchy.editSplats()) splat.radius += 1;
  const std::vector<NodeRange> ranges = {
      {3, 4}, {95, 305}, {hierarchy.nodeCount() - 1, hierarchy.nodeCount()}};
  for (const NodeRange& range : ranges) {
    for (Index node = range.begin; node < range.end; ++node) expected[node] = hierarchy.splats()[node];
  }
  store.upload(hierarchy, ranges);
  EXPECT_TRUE(areSame(splatsOf(store), expected));
}

TEST_F(SplatStoreTest, AnotherNumberOfNodesMakesRoomAnew) {
  SplatStore store(kChunk);
  for (const std::size_t count : {1000, 10, 2000}) {
    const Hierarchy hierarchy = scenes::hierarchyOf(scenes::sphere(count));
    store.upload(hierarchy, scenes::allNodes(hierarchy));
    EXPECT_TRUE(areSame(splatsOf(store), hierarchy.splats()));
  }
}

TEST_F(SplatStoreTest, ListsHoldEachNodeOnceByItsChunk) {
  const Hierarchy hierarchy = scenes::hierarchyOf(scenes::sphere(1000));
  SplatStore store(kChunk);
  store.upload(hierarchy, scenes::allNodes(hierarchy));
  const std::vector<Index> nodes = {900, 5, 307, 4, 301, 6};
  NodeList list;
  list.set(nodes, store);
  std::vector<Index> listed;
  for (const NodeList::Batch& batch : list.batches()) {
    EXPECT_EQ(batch.offset % gl::storageAlignment(), 0u);
    const std::vector<std::byte> bytes = list.buffer().read(batch.offset, batch.count * sizeof(Index));
    for (Index i = 0; i < batch.count; ++i) {
      Index node = 0;
      std::memcpy(&node, bytes.data() + i * sizeof(Index), sizeof(Index));
      EXPECT_EQ(node / store.nodesPerChunk(), batch.chunk);
      listed.push_back(node);
    }
  }
  EXPECT_EQ(listed, (std::vector<Index>{5, 4, 6, 307, 301, 900}));
}

}  // namespace
}  // namespace stipple
