#include "core/geometry/mesh_rings.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/geometry/fan_weights.h"

namespace stipple {

namespace {

struct RingEdge {
  Index from, to;
  double weight;
};

}  // namespace

void discretizeMesh(Discretization& d) {
  const Index count = d.size();
  std::vector<RingEdge> edges;
  edges.reserve(6 * d.meshTriangles.size());
  std::vector<Eigen::Vector3d> normals(count, Eigen::Vector3d::Zero());
  d.mass.assign(count, 0.0);
  for (const Triangle& t : d.meshTriangles) {
    Eigen::Vector3d x[3];
    for (std::size_t c = 0; c < 3; ++c) x[c] = d.sites.positions[t[c]].cast<double>();
    const Eigen::Vector3d cross = (x[1] - x[0]).cross(x[2] - x[0]);
    const double twiceArea = cross.norm();
    if (!(twiceArea > 0)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const Index a = t[(c + 1) % 3], b = t[(c + 2) % 3];
      const double halfCot = 0.5 * (x[(c + 1) % 3] - x[c]).dot(x[(c + 2) % 3] - x[c]) / twiceArea;
      edges.push_back({a, b, halfCot});
      edges.push_back({b, a, halfCot});
      normals[t[c]] += cross;
      d.mass[t[c]] += twiceArea / 6;
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const RingEdge& a, const RingEdge& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });

  d.fans = {};
  std::size_t next = 0;
  for (Index site = 0; site < count; ++site) {
    while (next < edges.size() && edges[next].from == site) {
      const Index to = edges[next].to;
      double weight = 0;
      for (; next < edges.size() && edges[next].from == site && edges[next].to == to; ++next)
        weight += edges[next].weight;
      d.fans.neighbors.push_back(to);
      d.weights.push_back(std::clamp(weight, -kMostWeight, kMostWeight));
    }
    d.fans.offsets.push_back(static_cast<Index>(d.fans.neighbors.size()));
    const bool alone = normals[site].isZero();
    d.normals.push_back(alone ? Eigen::Vector3f::UnitZ()
                              : Eigen::Vector3f(normals[site].normalized().cast<float>()));
  }
  d.fans.flags.assign(d.fans.neighbors.size(), Fans::kGapAfter);
  d.fans.open.assign(count, 0);
  d.fans.certified.assign(count, 1);
  d.resolved.assign(count, 1);
}

}  // namespace stipple
