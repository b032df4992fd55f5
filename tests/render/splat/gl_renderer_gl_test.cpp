#include "render/splat/gl_renderer.h"

#include "render/appearance/light.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/splat_scenes.h"

namespace stipple {
namespace {

using GlRendererTest = GlTest;

constexpr FramingSphere kUnit{};

Appearance plain() {
  Appearance appearance;
  appearance.lit = false;
  appearance.edgeStrength = 0;
  return appearance;
}

void drawAll(GlRenderer& renderer, const Hierarchy& hierarchy, const View& view, const Appearance& appearance,
             Accumulate accumulate = Accumulate::kStartAnew) {
  renderer.draw(hierarchy, scenes::allLeaves(hierarchy), view, appearance, accumulate);
}

TEST_F(GlRendererTest, PicksTheSplatInFront) {
  const Hierarchy hierarchy = scenes::hierarchyOf(scenes::sphere(20'000));
  GlRenderer renderer;
  renderer.upload(hierarchy, scenes::allNodes(hierarchy));
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    const View view = frameView(kUnit, {.yaw = 0.4f, .pitch = 0.3f, .projection = projection}, 200, 160);
    drawAll(renderer, hierarchy, view, {});
    int hits = 0;
    for (int y = 0; y < view.height; y += 7) {
      for (int x = 0; x < view.width; x += 7) {
        const std::optional<Pick> pick = renderer.pick(x, y);
        if (!pick) continue;
        ++hits;
        const Splat& splat = hierarchy.splats()[pick->node];
        // On the sphere, on its near side, within the disc (at the rim of the sphere: within its least
        // width).
        EXPECT_NEAR(glm::length(pick->position), 1, 0.01f);
        EXPECT_LT(pick->depth, glm::length(view.eye));
        EXPECT_LE(glm::distance(pick->position, splat.center()), 1.2f * splat.radius);
      }
    }
    EXPECT_GT(hits, 100);
    EXPECT_FALSE(renderer.pick(0, 0));
    EXPECT_FALSE(renderer.pick(-1, 0));
    EXPECT_FALSE(renderer.pick(view.width, 0));
  }
}

TEST_F(GlRendererTest, ChunksMakeNoDifference) {
  const Hierarchy hierarchy = scenes::hierarchyOf(scenes::torus(5'000));
  const View view = frameView({.radius = 1.4f}, {.pitch = 0.8f}, 160, 120);
  GlRenderer whole, chunked({.chunkBytes = 700 * sizeof(Splat)});
  std::vector<Image> images;
  Appearance discs;  // sums depend on the order of the splats, the nearest one does not
  discs.mode = SplatMode::kDiscs;
  for (GlRenderer* renderer : {&whole, &chunked}) {
    renderer->upload(hierarchy, scenes::allNodes(hierarchy));
    drawAll(*renderer, hierarchy, view, discs);
    images.push_back(renderer->image());
  }
  EXPECT_EQ(images[0].pixels, images[1].pixels);
}

TEST_F(GlRendererTest, ColorsOfAFlatSurfaceAreKept) {
  scenes::Surface square = scenes::square(4'000);
  square.colors.assign(square.colors.size(), Rgba8{200, 100, 50, 0});
  const Hierarchy hierarchy = scenes::hierarchyOf(square);
  const View view = frameView(kUnit, {.pitch = 1.5707963f, .zoom = 2}, 100, 100);
  GlRenderer renderer;
  renderer.upload(hierarchy, scenes::allNodes(hierarchy));
  for (const SplatMode mode : {SplatMode::kSplats, SplatMode::kDiscs}) {
    Appearance appearance = plain();
    appearance.mode = mode;
    drawAll(renderer, hierarchy, view, appearance);
    const Image image = renderer.image();
    for (const Rgba8& pixel : image.pixels) {
      EXPECT_NEAR(pixel.r, 200, 1);
      EXPECT_NEAR(pixel.g, 100, 1);
      EXPECT_NEAR(pixel.b, 50, 1);
      EXPECT_EQ(pixel.a, 255);
    }
  }
}

TEST_F(GlRendererTest, AccumulationIsTheMeanInLinearLight) {
  scenes::Surface square = scenes::square(2'000);
  GlRenderer renderer;
  const View view = frameView(kUnit, {.pitch = 1.5707963f, .zoom = 2}, 32, 32);
  const std::vector<Rgba8> colors = {{255, 0, 0, 0}, {0, 255, 0, 0}, {0, 0, 255, 0}};
  for (std::size_t i = 0; i < colors.size(); ++i) {
    square.colors.assign(square.colors.size(), colors[i]);
    const Hierarchy hierarchy = scenes::hierarchyOf(square);
    renderer.upload(hierarchy, scenes::allNodes(hierarchy));
    drawAll(renderer, hierarchy, view, plain(), i == 0 ? Accumulate::kStartAnew : Accumulate::kAddToMean);
  }
  const int third = encodeSrgb(1.f / 3);
  const Rgba8 mean = renderer.image().at(16, 16);
  EXPECT_NEAR(mean.r, third, 1);
  EXPECT_NEAR(mean.g, third, 1);
  EXPECT_NEAR(mean.b, third, 1);
}

TEST_F(GlRendererTest, WithoutBackgroundWhatIsEmptyIsTransparent) {
  const Hierarchy hierarchy = scenes::hierarchyOf(scenes::sphere(5'000));
  GlRenderer renderer;
  renderer.upload(hierarchy, scenes::allNodes(hierarchy));
  Appearance appearance = plain();
  appearance.background.reset();
  drawAll(renderer, hierarchy, frameView(kUnit, {}, 64, 64), appearance);
  const Image image = renderer.image();
  EXPECT_EQ(image.at(0, 0), (Rgba8{0, 0, 0, 0}));
  EXPECT_EQ(image.at(32, 32).a, 255);
}

class StopAtOnce : public Progress {
 public:
  bool cancelled() const override { return true; }
};

TEST_F(GlRendererTest, AStopLeavesThePictureAsItWas) {
  const Hierarchy hierarchy = scenes::hierarchyOf(scenes::sphere(5'000));
  GlRenderer renderer;
  renderer.upload(hierarchy, scenes::allNodes(hierarchy));
  drawAll(renderer, hierarchy, frameView(kUnit, {}, 64, 64), {});
  const Image before = renderer.image();
  const std::optional<Pick> pickBefore = renderer.pick(32, 32);
  const StopAtOnce stop;
  EXPECT_THROW(renderer.draw(hierarchy, {0}, frameView(kUnit, {}, 80, 40), {}, Accumulate::kStartAnew, &stop),
               Cancelled);
  EXPECT_EQ(renderer.image().pixels, before.pixels);
  ASSERT_TRUE(pickBefore && renderer.pick(32, 32));
  EXPECT_EQ(renderer.pick(32, 32)->node, pickBefore->node);
}

TEST_F(GlRendererTest, NoNodesGiveTheBackground) {
  const Hierarchy hierarchy = scenes::hierarchyOf(scenes::sphere(100));
  GlRenderer renderer;
  renderer.upload(hierarchy, scenes::allNodes(hierarchy));
  renderer.draw(hierarchy, {}, frameView(kUnit, {}, 8, 8), {}, Accumulate::kStartAnew);
  EXPECT_EQ(renderer.image().pixels, std::vector<Rgba8>(64, *Appearance{}.background));
}

}  // namespace
}  // namespace stipple
