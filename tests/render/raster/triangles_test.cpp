#include "render/raster/triangles.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <chrono>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <random>

#include "core/parallel.h"
#include "render/appearance/light.h"

namespace stipple {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A surface mesh that owns its columns.
struct Model {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<Rgba8> colors;
  std::vector<Triangle> triangles;

  SurfaceMesh mesh() const { return {positions, normals, colors, triangles}; }
  void add(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
    const auto first = static_cast<Index>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
  }
};

MeshLayer rasterize(const Model& model, const View& view) {
  MeshLayer layer;
  rasterizeTriangles(model.mesh(), view, layer);
  return layer;
}

View lookAt(Projection projection, int width = 96, int height = 64) {
  View view = frameView({{0.1F, -0.2F, 0.3F}, 1.5F},
                        {.yaw = 0.7F, .pitch = 0.4F, .zoom = 1.2F, .projection = projection}, width, height);
  view.jitterPx = {0.3F, -0.2F};
  return view;
}

Model randomTriangles(int count, float size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::uniform_int_distribution<int> channel(0, 255);
  const auto vector = [&] { return Eigen::Vector3f(uniform(random), uniform(random), uniform(random)); };
  Model model;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f center = 1.5F * vector();
    model.add(center + size * vector(), center + size * vector(), center + size * vector());
  }
  for (std::size_t i = 0; i < model.positions.size(); ++i) {
    model.normals.push_back(vector());
    model.colors.push_back({std::uint8_t(channel(random)), std::uint8_t(channel(random)),
                            std::uint8_t(channel(random)), std::uint8_t(channel(random))});
  }
  return model;
}

struct Hit {
  Index triangle = MeshLayer::kNone;
  double depth = std::numeric_limits<double>::infinity();
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  bool isUnclear = false;  ///< the ray passes so near by an edge that rounding decides
};

Eigen::Vector3d toEigen(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

/// Solves a + s (b - a) + t (c - a) = eye + depth * ray for every triangle, in the coordinates of the world.
Hit castRay(const Model& model, const View& view, double px, double py) {
  const double x = (px - view.centerPx().x) / view.focalPx, y = (py - view.centerPx().y) / view.focalPx;
  Eigen::Matrix3d viewFromWorld;  // inverted, not transposed: floats make no perfect rotation
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) viewFromWorld(row, column) = view.viewFromWorld[column][row];
  }
  const Eigen::Matrix3d worldFromView = viewFromWorld.inverse();
  const bool fromEye = view.isPerspective();
  const Eigen::Vector3d start =
      toEigen(view.eye) + worldFromView * (fromEye ? Eigen::Vector3d::Zero() : Eigen::Vector3d(x, y, 0));
  const Eigen::Vector3d ray = worldFromView * (fromEye ? Eigen::Vector3d(x, y, 1) : Eigen::Vector3d(0, 0, 1));
  Hit nearest;
  for (Index i = 0; i < model.triangles.size(); ++i) {
    const Eigen::Vector3d a = model.positions[model.triangles[i][0]].cast<double>();
    Eigen::Matrix3d system;
    system.col(0) = model.positions[model.triangles[i][1]].cast<double>() - a;
    system.col(1) = model.positions[model.triangles[i][2]].cast<double>() - a;
    system.col(2) = -ray;
    const Eigen::Vector3d solution = system.fullPivLu().solve(start - a);
    const Eigen::Vector3d weights(1 - solution[0] - solution[1], solution[0], solution[1]);
    constexpr double kNear = 1e-7;
    if (weights.minCoeff() < -kNear || solution[2] < view.nearDepth - kNear) continue;
    if (weights.minCoeff() < kNear || solution[2] < view.nearDepth + kNear) nearest.isUnclear = true;
    if (solution[2] < nearest.depth) nearest = {i, solution[2], weights, nearest.isUnclear};
  }
  return nearest;
}

void expectAsCast(const Model& model, const View& view) {
  const MeshLayer layer = rasterize(model, view);
  int seen = 0, unclear = 0;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const std::size_t pixel = static_cast<std::size_t>(row) * view.width + column;
      const Hit hit = castRay(model, view, column + 0.5, row + 0.5);
      if (hit.isUnclear && ++unclear > 0) continue;
      ASSERT_EQ(layer.triangles[pixel], hit.triangle) << column << " " << row;
      if (hit.triangle == MeshLayer::kNone) {
        ASSERT_EQ(layer.depth[pixel], kInfinity);
        ASSERT_EQ(layer.colors[pixel], glm::vec3(0));
        continue;
      }
      ++seen;
      ASSERT_NEAR(layer.depth[pixel], hit.depth, 1e-7 * hit.depth);
      const Triangle& corners = model.triangles[hit.triangle];
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      double red = 0, selected = 0;
      for (int i = 0; i < 3; ++i) {
        normal += hit.weights[i] * model.normals[corners[i]].cast<double>();
        red += hit.weights[i] * linearTable()[model.colors[corners[i]].r];
        selected += hit.weights[i] * model.colors[corners[i]].a / 255.0;
      }
      ASSERT_NEAR(layer.colors[pixel].r, red, 1e-4);
      ASSERT_NEAR(layer.selected[pixel], selected, 1e-4);
      const glm::vec3 back = glm::transpose(view.viewFromWorld) * layer.normals[pixel];
      if (normal.norm() < 0.01) continue;
      ASSERT_LT((toEigen(back) - normal.normalized()).norm(), 1e-3);
    }
  }
  EXPECT_GT(seen, view.width * view.height / 20);
  EXPECT_LT(unclear, 10);
}

TEST(RasterizeTriangles, SeesWhatRaysSee) {
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    expectAsCast(randomTriangles(60, 0.8F, 1), lookAt(projection));
    expectAsCast(randomTriangles(600, 0.1F, 2), lookAt(projection));
  }
}

TEST(RasterizeTriangles, CutsOffWhatIsTooNearOrBehindTheEye) {
  View inside = lookAt(Projection::kPerspective);
  inside.eye = {0.1F, 0, 0};
  inside.nearDepth = 0.3F;
  expectAsCast(randomTriangles(60, 1.5F, 3), inside);
  inside.nearDepth = 1e-6F;
  expectAsCast(randomTriangles(60, 1.5F, 4), inside);
  View above = lookAt(Projection::kOrthographic);
  above.nearDepth = 3;
  expectAsCast(randomTriangles(60, 0.8F, 5), above);
}

// How many triangles of the model hold each pixel, each drawn on its own.
std::vector<int> countCovers(const Model& model, const View& view) {
  std::vector<int> covers(static_cast<std::size_t>(view.width) * view.height, 0);
  for (const Triangle& triangle : model.triangles) {
    Model alone = model;
    alone.triangles = {triangle};
    const MeshLayer layer = rasterize(alone, view);
    for (std::size_t i = 0; i < covers.size(); ++i) covers[i] += layer.triangles[i] == 0;
  }
  return covers;
}

// A square that is cut into triangles: corners in the plane through (0, 0, 0), the rim fixed. Turns of
// triangles alternate.
Model cutSquare(int cells, float half, float shake) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-shake, shake);
  Model model;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const bool rim = i == 0 || j == 0 || i == cells || j == cells;
      const float s = 2 * half / static_cast<float>(cells);
      model.positions.emplace_back(static_cast<float>(i) * s - half + (rim ? 0 : s * uniform(random)), 0,
                                   static_cast<float>(j) * s - half + (rim ? 0 : s * uniform(random)));
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto a = static_cast<Index>(j * (cells + 1) + i), b = a + 1;
      const auto c = a + static_cast<Index>(cells) + 1, d = c + 1;
      if ((i + j) % 2 == 0) {
        model.triangles.insert(model.triangles.end(), {{a, b, d}, {d, a, c}});
      } else {
        model.triangles.insert(model.triangles.end(), {{c, b, a}, {b, c, d}});
      }
    }
  }
  return model;
}

TEST(RasterizeTriangles, CoverEveryPixelOfASheetOnce) {
  // Larger than the picture, seen askew.
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    const View view = frameView({{0, 0, 0}, 1},
                                {.yaw = 0.3F, .pitch = 0.2F, .zoom = 2.3F, .projection = projection}, 48, 48);
    EXPECT_THAT(countCovers(cutSquare(12, 2, 0.15F), view), testing::Each(1));
  }
}

TEST(RasterizeTriangles, GiveCornersOnPixelCentersToOneTriangle) {
  // Cells of four pixels whose corners are centers of pixels: left and upper rims belong to the square.
  View view = frameView({{0, 0, 0}, 16}, {.projection = Projection::kOrthographic}, 32, 32);
  view.focalPx = 1;
  view.jitterPx = {0.5F, 0.5F};
  const std::vector<int> covers = countCovers(cutSquare(6, 12, 0), view);
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 32; ++column) {
      const bool inside = row >= 4 && row < 28 && column >= 4 && column < 28;
      ASSERT_EQ(covers[row * 32 + column], inside) << column << " " << row;
    }
  }
}

TEST(RasterizeTriangles, TakeTheFirstOfEquallyNearOnes) {
  Model model = cutSquare(2, 1, 0);
  const std::vector<Triangle> once = model.triangles;
  model.triangles.insert(model.triangles.end(), once.begin(), once.end());
  for (const Index seen : rasterize(model, lookAt(Projection::kPerspective)).triangles) {
    EXPECT_TRUE(seen == MeshLayer::kNone || seen < once.size());
  }
}

TEST(RasterizeTriangles, WithoutNormalsAndColorsShowThePlaneInGray) {
  const Model model = cutSquare(2, 2, 0);
  const View view = lookAt(Projection::kPerspective);
  const MeshLayer layer = rasterize(model, view);
  int seen = 0;
  for (std::size_t i = 0; i < layer.depth.size(); ++i) {
    if (layer.triangles[i] == MeshLayer::kNone) continue;
    ++seen;
    const glm::vec3 back = glm::transpose(view.viewFromWorld) * layer.normals[i];
    EXPECT_NEAR(std::abs(back.y), 1, 1e-5);
    EXPECT_EQ(layer.colors[i].r, layer.colors[i].b);
    EXPECT_GT(layer.colors[i].r, 0.4F);
  }
  EXPECT_GT(seen, 100);
}

TEST(RasterizeTriangles, NormalsThatCancelOutGiveWayToThePlane) {
  Model model = cutSquare(1, 2, 0);
  model.normals.assign(4, Eigen::Vector3f::Zero());
  for (const glm::vec3& normal : rasterize(model, lookAt(Projection::kPerspective)).normals) {
    EXPECT_FALSE(std::isnan(normal.x));
  }
}

TEST(RasterizeTriangles, SurviveWhatIsDegenerate) {
  Model model;
  model.add({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  model.add({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  model.add({0, 0, 0}, {1, 0, 0}, {kNaN, 0, 1});
  model.add({0, 0, 0}, {1, 0, 0}, {0, kInfinity, 1});
  model.add({0, 0, 0}, {3e38F, 0, 0}, {0, 0, 3e38F});
  model.add({-3e38F, 1, 0}, {3e38F, 1, 0}, {0, 1, 3e38F});
  for (const Projection projection : {Projection::kPerspective, Projection::kOrthographic}) {
    const MeshLayer layer = rasterize(model, lookAt(projection));
    for (const float depth : layer.depth) EXPECT_FALSE(std::isnan(depth));
    for (const Index seen : layer.triangles) EXPECT_TRUE(seen == MeshLayer::kNone || seen > 3) << seen;
  }
  EXPECT_THAT(rasterize(Model{}, lookAt(Projection::kPerspective)).depth, testing::Each(kInfinity));
  EXPECT_THAT(rasterize(model, View{}).depth, testing::IsEmpty());
}

TEST(RasterizeTriangles, ManyLongNeedlesTakeNoLongTime) {
  // Their boxes cover the whole picture, they themselves some pixels of a row.
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Model model;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3f a(-5, uniform(random), -5), b(5, uniform(random), 5);
    model.add(a, b, b + Eigen::Vector3f(1e-3F, 0, 1e-3F));
  }
  const auto start = std::chrono::steady_clock::now();
  rasterize(model, frameView({{0, 0, 0}, 1}, {}, 640, 640));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(RasterizeTriangles, DoNotDependOnTheNumberOfThreads) {
  const Model model = randomTriangles(3000, 0.4F, 6);
  const View view = lookAt(Projection::kPerspective, 200, 150);
  const MeshLayer all = rasterize(model, view);
  const ThreadLimit one(1);
  const MeshLayer alone = rasterize(model, view);
  EXPECT_EQ(all.depth, alone.depth);
  EXPECT_EQ(all.triangles, alone.triangles);
  EXPECT_EQ(all.normals, alone.normals);
  EXPECT_EQ(all.colors, alone.colors);
}

TEST(RasterizeTriangles, CanBeCancelled) {
  class Stop final : public Progress {
    bool cancelled() const override { return true; }
  };
  const Stop stop;
  MeshLayer layer;
  EXPECT_THROW(
      rasterizeTriangles(randomTriangles(10, 1, 1).mesh(), lookAt(Projection::kPerspective), layer, &stop),
      Cancelled);
}

}  // namespace
}  // namespace stipple
