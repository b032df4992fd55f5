#include "render/splat/gl_renderer.h"

#include <array>
#include <bit>
#include <cassert>
#include <limits>
#include <span>
#include <utility>

#include "core/error.h"
#include "render/gl/pipeline.h"
#include "render/splat/frame_block.h"
#include "render/splat/mesh_buffers.h"

namespace stipple {

namespace {

// Bindings of the shaders.
constexpr unsigned kFrameSlot = 0;
constexpr unsigned kSplatSlot = 0, kNodeSlot = 1;
constexpr int kFirstNodeLocation = 0;

// First channel of a visible texel: shaders/frame.glsl.
constexpr std::uint32_t kNothing = 0xffffffff, kTriangle = 0xfffffffe;

glm::vec4 texelOf(const gl::Texture2D& texture, int x, int y) {
  glm::vec4 texel(0);
  texture.read(x, y, 1, 1, std::as_writable_bytes(std::span(&texel, 1)));
  return texel;
}

}  // namespace

GlRenderer::GlRenderer(const GlOptions& options)
    : visibility_(options.shaders, "visibility.vert", "visibility.frag"),
      attributes_(options.shaders, "attributes.vert", "attributes.frag"),
      mesh_(options.shaders, "mesh.vert", "mesh.frag"),
      resolve_(options.shaders, "screen.vert", "resolve.frag"),
      encode_(options.shaders, "screen.vert", "encode.frag"),
      frameBlock_(sizeof(FrameBlock)),
      store_(options.chunkBytes) {
  if (gl::vertexStorageBlocks() < 2) {
    throw IoError(
        "this graphics card lets vertex shaders read no storage buffers, and splats are read from two");
  }
}

void GlRenderer::upload(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed) {
  store_.upload(hierarchy, changed);
}

void GlRenderer::draw([[maybe_unused]] const Hierarchy& hierarchy, const std::vector<Index>& nodes,
                      const View& view, const Appearance& appearance, Accumulate accumulate,
                      const Progress* progress) {
  assert(hierarchy.nodeCount() == store_.nodeCount());
  next_.set(nodes, store_);
  drawListed(next_, view, appearance, accumulate, progress);
  std::swap(list_, next_);
}

void GlRenderer::redraw(const Hierarchy&, const std::vector<NodeRange>&) {
  if (frames_ > 0) drawListed(list_, View(view_), Appearance(appearance_), Accumulate::kStartAnew, nullptr);
}

void GlRenderer::drawListed(const NodeList& list, const View& view, const Appearance& appearance,
                            Accumulate accumulate, const Progress* progress) {
  const gl::CallersTarget callers;
  const bool isBlended = appearance.mode == SplatMode::kSplats;
  beginFrame(view, appearance, isBlended);

  gl::apply({.depth = gl::DepthTest::kNearest});
  current_.visibility.bind();
  current_.visibility.clearColor(0, std::array<std::uint32_t, 4>{kNothing, 0, 0, 0});
  current_.visibility.clearDepth(0);
  drawSplats(visibility_, list, progress);

  if (isBlended) {
    gl::apply({.depth = gl::DepthTest::kNotBehind, .blend = gl::Blend::kSum});
    current_.sums.bind();
    for (const int sum : {0, 1}) current_.sums.clearColor(sum, std::array<float, 4>{});
    current_.visible.bind(0);
    drawSplats(attributes_, list, progress);
  }
  finishFrame(view, appearance, accumulate);
}

void GlRenderer::drawMesh(const SurfaceMesh& mesh, const View& view, const Appearance& appearance,
                          Accumulate accumulate, const Progress* progress) {
  const gl::CallersTarget callers;
  const MeshBuffers buffers(mesh);
  if (progress) progress->throwIfCancelled();
  beginFrame(view, appearance, true);

  gl::apply({.depth = gl::DepthTest::kNearest, .clipDistances = 1});
  current_.mesh.bind();
  current_.mesh.clearColor(0, std::array<std::uint32_t, 4>{kNothing, 0, 0, 0});
  current_.mesh.clearDepth(0);
  mesh_.use();
  buffers.draw();
  finishFrame(view, appearance, accumulate);
}

void GlRenderer::beginFrame(const View& view, const Appearance& appearance, bool isBlended) {
  if (view.width != current_.width() || view.height != current_.height()) {
    current_ = FrameTargets(view.width, view.height);
  }
  const FrameBlock block = makeFrameBlock(view, appearance, isBlended);
  frameBlock_.write<FrameBlock>(0, std::span(&block, 1));
  frameBlock_.bindUniform(kFrameSlot);
}

void GlRenderer::drawSplats(gl::Program& program, const NodeList& list, const Progress* progress) {
  program.use();
  noAttributes_.bind();
  for (const NodeList::Batch& batch : list.batches()) {
    if (progress) progress->throwIfCancelled();
    const gl::Buffer& chunk = store_.chunk(batch.chunk);
    chunk.bindStorage(kSplatSlot, 0, chunk.size());
    list.buffer().bindStorage(kNodeSlot, batch.offset, batch.count * sizeof(Index));
    program.setUniform(kFirstNodeLocation, static_cast<Index>(batch.chunk) * store_.nodesPerChunk());
    gl::drawTriangles(batch.count);
  }
}

void GlRenderer::finishFrame(const View& view, const Appearance& appearance, Accumulate accumulate) {
  if (view.width != picture_.width() || view.height != picture_.height()) {
    picture_ = PictureTargets(view.width, view.height);
    frames_ = 0;
  }
  if (accumulate == Accumulate::kStartAnew) frames_ = 0;
  ++frames_;
  gl::apply({.blend = frames_ == 1 ? gl::Blend::kReplace : gl::Blend::kMean,
             .meanWeight = 1 / static_cast<float>(frames_)});
  picture_.accumulation.bind();
  current_.visible.bind(0);
  current_.colorSum.bind(1);
  current_.normalSum.bind(2);
  resolve_.use();
  noAttributes_.bind();
  gl::drawTriangles(1);

  std::swap(current_, last_);
  view_ = view;
  appearance_ = appearance;
}

void GlRenderer::encode() {
  const FrameBlock block = makeFrameBlock(view_, appearance_, false);
  frameBlock_.write<FrameBlock>(0, std::span(&block, 1));
  frameBlock_.bindUniform(kFrameSlot);
  gl::apply({});
  picture_.encoding.bind();
  picture_.mean.bind(0);
  encode_.use();
  noAttributes_.bind();
  gl::drawTriangles(1);
}

Image GlRenderer::image() {
  Image image;
  if (frames_ == 0) return image;
  const gl::CallersTarget callers;
  encode();
  image.width = picture_.width();
  image.height = picture_.height();
  image.pixels.resize(static_cast<std::size_t>(image.width) * image.height);
  picture_.encoded.read(0, 0, image.width, image.height, std::as_writable_bytes(std::span(image.pixels)));
  return image;
}

void GlRenderer::present() {
  if (frames_ == 0) return;
  const gl::CallersTarget callers;
  encode();
  gl::blitFlipped(picture_.encoding, picture_.width(), picture_.height(), callers.drawName());
}

std::optional<Pick> GlRenderer::pick(int x, int y) {
  if (frames_ == 0 || x < 0 || y < 0 || x >= last_.width() || y >= last_.height()) return std::nullopt;
  std::array<std::uint32_t, 4> texel{};
  last_.visible.read(x, y, 1, 1, std::as_writable_bytes(std::span(texel)));
  if (texel[0] == kNothing || texel[0] == kTriangle) return std::nullopt;
  float depth = std::bit_cast<float>(texel[3]);
  if (appearance_.mode == SplatMode::kSplats) {
    // The mean depth of what is blended, as shaders/resolve.frag has it.
    depth += texelOf(last_.normalSum, x, y).w / texelOf(last_.colorSum, x, y).w / view_.pixelsPerUnit(depth);
  }
  const glm::vec2 px(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  return Pick{.node = texel[0], .depth = depth, .position = view_.toWorld(view_.fromPixels(px, depth))};
}

std::vector<float> GlRenderer::depth() {
  if (frames_ == 0) return {};
  const std::size_t pixels = static_cast<std::size_t>(last_.width()) * last_.height();
  std::vector<std::array<std::uint32_t, 4>> texels(pixels);
  last_.visible.read(0, 0, last_.width(), last_.height(), std::as_writable_bytes(std::span(texels)));
  std::vector<float> depth(pixels, std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < pixels; ++i) {
    if (texels[i][0] != kNothing) depth[i] = std::bit_cast<float>(texels[i][3]);
  }
  return depth;
}

}  // namespace stipple
