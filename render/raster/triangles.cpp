#include "render/raster/triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <tuple>

#include "render/appearance/light.h"

namespace stipple {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kBandRows = 16;
constexpr std::size_t kTriangleGrain = 4096;
constexpr glm::vec3 kPlainColor(0.604f);  // linear value of the light gray of points without color

// The view in double precision, so that edges and depths are exact to the last bits of a float.
class PreciseView {
 public:
  explicit PreciseView(const View& view)
      : rotation_(view.viewFromWorld),
        eye_(view.eye),
        center_(view.centerPx()),
        focal_(view.focalPx),
        perspective_(view.isPerspective()) {
    near_ =
        perspective_ ? std::max<double>(view.nearDepth, std::numeric_limits<float>::min()) : view.nearDepth;
  }
  dvec3 toView(const Eigen::Vector3f& world) const {
    return rotation_ * (dvec3(world.x(), world.y(), world.z()) - eye_);
  }
  // Pixel coordinates = inPlane(corner).xy / inPlane(corner).z. In these coordinates, that of a pixel is
  // (x, y, 1), and points before and behind the eye need no distinction.
  dvec3 inPlane(const dvec3& inView) const {
    const double scale = perspective_ ? inView.z : 1;
    return {focal_ * inView.x + center_.x * scale, focal_ * inView.y + center_.y * scale, scale};
  }
  double nearDepth() const { return near_; }

 private:
  glm::dmat3 rotation_;
  dvec3 eye_;
  dvec2 center_;
  double focal_;
  double near_;
  bool perspective_;
};

// a * x + b * y + c, positive inside of the triangle.
struct Edge {
  double a = 0, b = 0, c = 0;
  double at(double x, double y) const { return a * x + (b * y + c); }
  // Left edges and upper edges own the pixels on them.
  bool ownsItsPixels() const { return a > 0 || (a == 0 && b > 0); }
  bool holds(double value) const { return value > 0 || (value == 0 && ownsItsPixels()); }
};

// The edge through two corners. Both triangles beside an edge get the same numbers but for the sign: corners
// are taken in the order of their coordinates.
Edge edgeThrough(const dvec3& from, const dvec3& to) {
  const auto comesBefore = [](const dvec3& p, const dvec3& q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  const bool turned = comesBefore(to, from);
  const dvec3 line = turned ? -glm::cross(to, from) : glm::cross(from, to);
  return {line.x, line.y, line.z};
}

// A triangle as the pixels see it: edge functions over the plane of the picture in homogeneous coordinates
// (Olano and Greer 1997), whose values at a pixel are also the weights of the opposite corners.
struct ProjectedTriangle {
  std::array<dvec3, 3> corners;  // view space
  std::array<Edge, 3> edges;     // opposite to the corners
  bool isSeen = false;

  ProjectedTriangle(const SurfaceMesh& mesh, const Triangle& triangle, const PreciseView& view) {
    std::array<dvec3, 3> inPlane;
    for (int i = 0; i < 3; ++i) {
      corners[i] = view.toView(mesh.positions[triangle[i]]);
      inPlane[i] = view.inPlane(corners[i]);
    }
    for (int i = 0; i < 3; ++i) edges[i] = edgeThrough(inPlane[(i + 1) % 3], inPlane[(i + 2) % 3]);
    const double area = glm::dot(inPlane[0], dvec3(edges[0].a, edges[0].b, edges[0].c));
    isSeen = std::isfinite(area) && area != 0;
    if (area > 0) return;
    for (Edge& e : edges) e = {-e.a, -e.b, -e.c};
  }

  // Sum to 1 in a pixel of the triangle.
  dvec3 weightsAt(double x, double y) const {
    const dvec3 values(edges[0].at(x, y), edges[1].at(x, y), edges[2].at(x, y));
    return values / (values.x + values.y + values.z);
  }
  double depthOf(const dvec3& weights) const {
    return weights.x * corners[0].z + weights.y * corners[1].z + weights.z * corners[2].z;
  }
};

// Half-open range of pixels.
struct PixelRange {
  int begin = 0, end = 0;
};

// Pixels whose centers lie in [low, high], within [0, size); one more on either side, for rounding.
PixelRange pixelsBetween(double low, double high, int size) {
  const double begin = std::clamp(std::floor(low - 0.5), 0.0, double(size));
  const double end = std::clamp(std::ceil(high + 0.5), 0.0, double(size));
  return {static_cast<int>(begin), std::max(static_cast<int>(begin), static_cast<int>(end))};
}

// The rows that the part of a triangle beyond the near depth covers. Empty where it is not seen.
PixelRange rowsOf(const SurfaceMesh& mesh, const Triangle& triangle, const PreciseView& view, int height) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto include = [&](const dvec3& inView) {
    const dvec3 p = view.inPlane(inView);
    low = std::min(low, p.y / p.z);
    high = std::max(high, p.y / p.z);
  };
  std::array<dvec3, 3> corners;
  for (int i = 0; i < 3; ++i) {
    corners[i] = view.toView(mesh.positions[triangle[i]]);
    if (!std::isfinite(corners[i].x + corners[i].y + corners[i].z)) return {};
  }
  const double near = view.nearDepth();
  for (int i = 0; i < 3; ++i) {
    const dvec3 &a = corners[i], &b = corners[(i + 1) % 3];
    if (a.z >= near) include(a);
    if ((a.z < near) != (b.z < near)) include(a + (b - a) * ((near - a.z) / (b.z - a.z)));
  }
  return low <= high ? pixelsBetween(low, high, height) : PixelRange{};
}

// The pixels of a row where all edges can be positive; those at its ends are still to be tested.
PixelRange columnsOf(const ProjectedTriangle& triangle, double y, int width) {
  double low = 0, high = width;
  for (const Edge& edge : triangle.edges) {
    const double rest = edge.b * y + edge.c;
    if (edge.a > 0) low = std::max(low, -rest / edge.a);
    if (edge.a < 0) high = std::min(high, -rest / edge.a);
    if (edge.a == 0 && rest < 0) return {};
  }
  return low <= high ? pixelsBetween(low, high, width) : PixelRange{};
}

// Triangles by the bands of rows that they touch: those of band b are [offsets[b], offsets[b + 1]),
// ascending.
struct Bands {
  std::vector<std::size_t> offsets;
  std::vector<Index> triangles;
};

Bands sortIntoBands(const SurfaceMesh& mesh, const PreciseView& view, int height, const Progress* progress) {
  std::vector<PixelRange> bandsOfTriangle(mesh.triangles.size());
  parallelFor(
      mesh.triangles.size(), kTriangleGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          const PixelRange rows = rowsOf(mesh, mesh.triangles[t], view, height);
          if (rows.begin < rows.end)
            bandsOfTriangle[t] = {rows.begin / kBandRows, (rows.end - 1) / kBandRows + 1};
        }
      },
      progress);
  Bands bands;
  bands.offsets.resize(static_cast<std::size_t>((height + kBandRows - 1) / kBandRows) + 1);
  for (const PixelRange& range : bandsOfTriangle) {
    for (int b = range.begin; b < range.end; ++b) ++bands.offsets[b + 1];
  }
  for (std::size_t b = 1; b < bands.offsets.size(); ++b) bands.offsets[b] += bands.offsets[b - 1];
  bands.triangles.resize(bands.offsets.back());
  std::vector<std::size_t> next(bands.offsets.begin(), bands.offsets.end() - 1);
  for (std::size_t t = 0; t < bandsOfTriangle.size(); ++t) {
    for (int b = bandsOfTriangle[t].begin; b < bandsOfTriangle[t].end; ++b)
      bands.triangles[next[b]++] = static_cast<Index>(t);
  }
  return bands;
}

// Draws into rows of the layer.
class MeshPainter {
 public:
  MeshPainter(const SurfaceMesh& mesh, const View& view, MeshLayer& layer)
      : mesh_(mesh), view_(view), rotation_(view.viewFromWorld), layer_(layer), width_(view.width) {}

  const PreciseView& view() const { return view_; }

  // The nearest triangle of each pixel.
  void findNearest(Index index, const PixelRange& rows) const {
    const ProjectedTriangle triangle(mesh_, mesh_.triangles[index], view_);
    if (!triangle.isSeen) return;
    const auto& [e0, e1, e2] = triangle.edges;
    for (int row = rows.begin; row < rows.end; ++row) {
      const double y = row + 0.5;
      const PixelRange columns = columnsOf(triangle, y, width_);
      for (int column = columns.begin; column < columns.end; ++column) {
        const double x = column + 0.5;
        if (!e0.holds(e0.at(x, y)) || !e1.holds(e1.at(x, y)) || !e2.holds(e2.at(x, y))) continue;
        const double depth = triangle.depthOf(triangle.weightsAt(x, y));
        const std::size_t pixel = static_cast<std::size_t>(row) * width_ + column;
        if (depth < view_.nearDepth() || !(static_cast<float>(depth) < layer_.depth[pixel])) continue;
        layer_.depth[pixel] = static_cast<float>(depth);
        layer_.triangles[pixel] = index;
      }
    }
  }

  // Normals and colors of what was found.
  void fillIn(const PixelRange& rows) const {
    for (int row = rows.begin; row < rows.end; ++row) {
      for (int column = 0; column < width_; ++column) {
        const std::size_t pixel = static_cast<std::size_t>(row) * width_ + column;
        if (layer_.triangles[pixel] == MeshLayer::kNone) continue;
        const Triangle& corners = mesh_.triangles[layer_.triangles[pixel]];
        const ProjectedTriangle triangle(mesh_, corners, view_);
        const dvec3 weights = triangle.weightsAt(column + 0.5, row + 0.5);
        layer_.normals[pixel] = normalOf(corners, triangle, weights);
        fillInColor(pixel, corners, weights);
      }
    }
  }

 private:
  glm::vec3 normalOf(const Triangle& triangle, const ProjectedTriangle& projected,
                     const dvec3& weights) const {
    if (!mesh_.normals.empty()) {
      dvec3 sum(0);
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3f& n = mesh_.normals[triangle[i]];
        sum += weights[i] * dvec3(n.x(), n.y(), n.z());
      }
      const dvec3 normal = glm::normalize(rotation_ * sum);
      if (std::isfinite(normal.x + normal.y + normal.z)) return normal;
    }
    const auto& [a, b, c] = projected.corners;
    return glm::normalize(glm::cross(b - a, c - a));
  }

  void fillInColor(std::size_t pixel, const Triangle& triangle, const dvec3& weights) const {
    layer_.colors[pixel] = kPlainColor;
    if (mesh_.colors.empty()) return;
    const auto& linear = linearTable();
    glm::vec3 color(0);
    float selected = 0;
    for (int i = 0; i < 3; ++i) {
      const Rgba8& corner = mesh_.colors[triangle[i]];
      const auto weight = static_cast<float>(weights[i]);
      color += weight * glm::vec3(linear[corner.r], linear[corner.g], linear[corner.b]);
      selected += weight * static_cast<float>(corner.a) / 255;
    }
    layer_.colors[pixel] = color;
    layer_.selected[pixel] = selected;
  }

  const SurfaceMesh& mesh_;
  PreciseView view_;
  glm::dmat3 rotation_;
  MeshLayer& layer_;
  int width_;
};

}  // namespace

void rasterizeTriangles(const SurfaceMesh& mesh, const View& view, MeshLayer& out, const Progress* progress) {
  const std::size_t pixels = static_cast<std::size_t>(view.width) * view.height;
  out.depth.assign(pixels, std::numeric_limits<float>::infinity());
  out.triangles.assign(pixels, MeshLayer::kNone);
  out.normals.assign(pixels, glm::vec3(0));
  out.colors.assign(pixels, glm::vec3(0));
  out.selected.assign(pixels, 0);
  const MeshPainter painter(mesh, view, out);
  const Bands bands = sortIntoBands(mesh, painter.view(), view.height, progress);
  parallelFor(
      bands.offsets.size() - 1, 1,
      [&](std::size_t band, std::size_t) {
        const int begin = static_cast<int>(band) * kBandRows;
        const PixelRange rows{begin, std::min(begin + kBandRows, view.height)};
        constexpr std::size_t kTrianglesBetweenLooks = 256;
        for (std::size_t t = bands.offsets[band]; t < bands.offsets[band + 1]; ++t) {
          if (progress && t % kTrianglesBetweenLooks == 0) progress->throwIfCancelled();
          painter.findNearest(bands.triangles[t], rows);
        }
        painter.fillIn(rows);
      },
      progress);
}

}  // namespace stipple
