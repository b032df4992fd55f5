#include "tests/support/mesh_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <numeric>

namespace stipple::scenes {

namespace {

glm::dvec3 toGlm(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

/// Inner nodes have their first child right behind them; leaves have triangles.
struct BoxNode {
  Box box;
  Index second = 0;          // inner: the second child
  Index begin = 0, end = 0;  // leaf: in the order of triangles
  bool isLeaf() const { return begin < end; }
};

struct CornerWeights {
  Index triangle = 0;
  double distance = std::numeric_limits<double>::infinity();
  std::array<double, 3> weights{};
};

class BoxTree {
 public:
  BoxTree(std::span<const Eigen::Vector3f> positions, const std::vector<Triangle>& triangles) {
    order_.resize(triangles.size());
    std::iota(order_.begin(), order_.end(), 0u);
    for (const Triangle& t : triangles) {
      corners_.push_back({toGlm(positions[t[0]]), toGlm(positions[t[1]]), toGlm(positions[t[2]])});
    }
    if (!triangles.empty()) build(0, static_cast<Index>(order_.size()));
  }

  std::optional<CornerWeights> firstHit(const Ray& ray) const {
    CornerWeights nearest;
    glm::dvec3 inverse(0);
    for (int axis = 0; axis < 3; ++axis)
      inverse[axis] = 1 / (ray.direction[axis] == 0 ? 1e-300 : ray.direction[axis]);
    std::array<Index, 64> open{};
    std::size_t count = nodes_.empty() ? 0 : 1;
    while (count > 0) {
      const Index n = open[--count];
      const BoxNode& node = nodes_[n];
      if (!meets(node.box, ray, inverse, nearest.distance)) continue;
      if (node.isLeaf()) {
        for (Index i = node.begin; i < node.end; ++i) intersect(ray, order_[i], nearest);
        continue;
      }
      open[count++] = node.second;
      open[count++] = n + 1;
    }
    if (std::isinf(nearest.distance)) return std::nullopt;
    return nearest;
  }

 private:
  glm::dvec3 middle(Index triangle) const {
    const auto& [a, b, c] = corners_[triangle];
    return (a + b + c) / 3.0;
  }

  Index build(Index begin, Index end) {
    const Index self = static_cast<Index>(nodes_.size());
    nodes_.emplace_back();
    Box box, middles;
    for (Index i = begin; i < end; ++i) {
      for (const glm::dvec3& corner : corners_[order_[i]]) box.add(corner);
      middles.add(middle(order_[i]));
    }
    nodes_[self].box = box;
    if (end - begin <= 4) {
      nodes_[self].begin = begin;
      nodes_[self].end = end;
      return self;
    }
    const glm::dvec3 extent = middles.high - middles.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const Index half = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                     [&](Index a, Index b) { return middle(a)[axis] < middle(b)[axis]; });
    build(begin, half);
    const Index second = build(half, end);
    nodes_[self].second = second;
    return self;
  }

  static bool meets(const Box& box, const Ray& ray, const glm::dvec3& inverse, double before) {
    const glm::dvec3 a = (box.low - ray.origin) * inverse, b = (box.high - ray.origin) * inverse;
    const glm::dvec3 enter = glm::min(a, b), leave = glm::max(a, b);
    // A little wider than the box, for rounding.
    const double first = std::max({enter.x, enter.y, enter.z, 0.0}),
                 last = std::min({leave.x, leave.y, leave.z, before});
    return first <= last * (1 + 1e-12);
  }

  /// Möller and Trumbore 1997; edges belong to both of their triangles.
  void intersect(const Ray& ray, Index triangle, CornerWeights& nearest) const {
    constexpr double kEdge = 1e-9;
    const auto& [a, b, c] = corners_[triangle];
    const glm::dvec3 ab = b - a, ac = c - a, across = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, across);
    if (determinant == 0) return;
    const glm::dvec3 from = ray.origin - a;
    const double u = glm::dot(from, across) / determinant;
    if (u < -kEdge || u > 1 + kEdge) return;
    const glm::dvec3 q = glm::cross(from, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    if (v < -kEdge || u + v > 1 + kEdge) return;
    const double distance = glm::dot(ac, q) / determinant;
    if (distance <= 0 || distance >= nearest.distance) return;
    nearest = {triangle, distance, {1 - u - v, u, v}};
  }

  std::vector<std::array<glm::dvec3, 3>> corners_;  // by triangle
  std::vector<Index> order_;
  std::vector<BoxNode> nodes_;
};

glm::dvec3 faceNormal(const PointSet& mesh, const Triangle& t) {
  const std::span<const Eigen::Vector3f> p = mesh.positions();
  return glm::cross(toGlm(p[t[1]]) - toGlm(p[t[0]]), toGlm(p[t[2]]) - toGlm(p[t[0]]));
}

}  // namespace

RaySurface castMesh(const PointSet& mesh, std::span<const Eigen::Vector3f> normals) {
  struct Caster {
    PointSet mesh;
    std::vector<Eigen::Vector3f> normals;
    BoxTree tree;
  };
  const auto caster = std::make_shared<const Caster>(
      Caster{mesh, {normals.begin(), normals.end()}, BoxTree(mesh.positions(), mesh.triangles())});
  const auto firstHit = [caster](const Ray& ray) -> std::optional<SurfacePoint> {
    const std::optional<CornerWeights> hit = caster->tree.firstHit(ray);
    if (!hit) return std::nullopt;
    const Triangle& triangle = caster->mesh.triangles()[hit->triangle];
    SurfacePoint point{.position = ray.origin + hit->distance * ray.direction};
    const bool isColored = caster->mesh.has("color");
    for (int k = 0; k < 3; ++k) {
      const Rgba8 c =
          isColored ? caster->mesh.values<Rgba8>("color")[triangle[k]] : Rgba8{200, 200, 200, 255};
      point.albedo += hit->weights[k] / 255 * glm::dvec3(c.r, c.g, c.b);
      if (!caster->normals.empty()) point.normal += hit->weights[k] * toGlm(caster->normals[triangle[k]]);
    }
    if (glm::length(point.normal) < 1e-9) point.normal = faceNormal(caster->mesh, triangle);
    point.normal = glm::normalize(point.normal);
    return point;
  };
  return {firstHit, framingSphere(mesh.positions())};
}

std::vector<Eigen::Vector3f> cornerNormals(const PointSet& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.size(), Eigen::Vector3f::Zero());
  for (const Triangle& t : mesh.triangles()) {
    const glm::dvec3 n = faceNormal(mesh, t);
    for (const Index corner : t) normals[corner] += Eigen::Vector3f(float(n.x), float(n.y), float(n.z));
  }
  for (Eigen::Vector3f& n : normals) n = n.stableNormalized();
  return normals;
}

FramingSphere framingSphere(std::span<const Eigen::Vector3f> positions) {
  Box box;
  for (const Eigen::Vector3f& p : positions) box.add(toGlm(p));
  const glm::dvec3 center = 0.5 * (box.low + box.high);
  double radius = 0;
  for (const Eigen::Vector3f& p : positions) radius = std::max(radius, glm::distance(center, toGlm(p)));
  return {glm::vec3(center), static_cast<float>(radius)};
}

}  // namespace stipple::scenes
