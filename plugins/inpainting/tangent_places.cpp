#include "plugins/inpainting/tangent_places.h"

#include <Eigen/Geometry>
#include <queue>
#include <tuple>

#include "core/geometry/moments.h"

namespace stipple {

namespace {

// A disc of 3.5 spacings, as wide as patches are, holds 38 points of an even scan.
constexpr int kNeighbors = 48;
// Neighbors that frames are carried to, and that normals come from.
constexpr int kCarried = 16;
constexpr float kSteepest = 0.77f;  // sine of 50 degrees

Eigen::Matrix3f firstFrame(const Eigen::Vector3f& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  Eigen::Matrix3f frame;
  frame.col(2) = normal;
  frame.col(0) = (Eigen::Vector3f::Unit(axis) - normal[axis] * normal).normalized();
  frame.col(1) = normal.cross(frame.col(0));
  return frame;
}

Eigen::Matrix3f carried(const Eigen::Matrix3f& from, const Eigen::Vector3f& unsignedNormal) {
  Eigen::Matrix3f frame;
  const float side = from.col(2).dot(unsignedNormal) < 0 ? -1.f : 1.f;
  const Eigen::Vector3f normal = side * unsignedNormal;
  const Eigen::Vector3f tangent = from.col(0) - from.col(0).dot(normal) * normal;
  if (tangent.squaredNorm() < 1e-4f) return firstFrame(normal);
  frame.col(2) = normal;
  frame.col(0) = tangent.normalized();
  frame.col(1) = normal.cross(frame.col(0));
  return frame;
}

}  // namespace

Eigen::Vector2f TangentPlaces::placeOf(Index site, const Eigen::Vector3f& position) const {
  const Eigen::Vector3f offset = position - positions[site];
  const Eigen::Vector2f projected = frames[site].leftCols<2>().transpose() * offset;
  const float length = projected.norm();
  if (!(length > 0)) return Eigen::Vector2f::Zero();
  return projected * (offset.norm() / (length * spacing));
}

Index TangentPlaces::nearest(Index site, const Eigen::Vector2f& place) const {
  Index best = site;
  float least = place.squaredNorm();
  for (std::size_t n = offsets[site]; n < offsets[site + 1]; ++n) {
    const float distance = (places[n] - place).squaredNorm();
    if (distance < least) {
      least = distance;
      best = neighbors[n];
    }
  }
  return best;
}

std::vector<Eigen::Matrix3f> carryFrames(const Sites& sites, Index start, const Progress* progress) {
  const Neighborhoods near = findNeighborhoods(sites, {.k = kCarried}, progress);
  const std::vector<Moments> moments = fitMoments(sites, near, progress);
  std::vector<Eigen::Matrix3f> frames(sites.size());
  std::vector<std::uint8_t> isDone(sites.size(), 0);
  using Arrival = std::tuple<float, Index, Index>;  // distance, site, where from
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> front;
  const auto arriveAt = [&](Index site, float distance) {
    isDone[site] = 1;
    const std::span<const Index> neighbors = near.of(site);
    const std::span<const float> squared = near.squaredDistancesOf(site);
    for (std::size_t n = 0; n < neighbors.size(); ++n) {
      if (!isDone[neighbors[n]]) front.emplace(distance + std::sqrt(squared[n]), neighbors[n], site);
    }
  };
  for (Index next = 0, seed = start; next < sites.size(); seed = next) {
    if (!isDone[seed]) {
      frames[seed] = firstFrame(moments[seed].axes.col(2));
      arriveAt(seed, 0);
    }
    while (!front.empty()) {
      const auto [distance, site, from] = front.top();
      front.pop();
      if (isDone[site]) continue;
      frames[site] = carried(frames[from], moments[site].axes.col(2));
      arriveAt(site, distance);
    }
    if (progress) progress->throwIfCancelled();
    while (next < sites.size() && isDone[next]) ++next;
  }
  return frames;
}

TangentPlaces findTangentPlaces(const Sites& sites, std::vector<Eigen::Matrix3f> frames, float spacing,
                                const Progress* progress) {
  const Neighborhoods near = findNeighborhoods(sites, {.k = kNeighbors}, progress);
  TangentPlaces result{.spacing = spacing, .positions = sites.positions, .frames = std::move(frames)};
  result.offsets.reserve(sites.size() + 1);
  result.offsets.push_back(0);
  result.neighbors.reserve(near.neighbors.size());
  result.places.reserve(near.neighbors.size());
  for (Index site = 0; site < sites.size(); ++site) {
    for (const Index neighbor : near.of(site)) {
      const Eigen::Vector3f offset = sites.positions[neighbor] - sites.positions[site];
      if (std::abs(offset.dot(result.frames[site].col(2))) > kSteepest * offset.norm()) continue;
      result.neighbors.push_back(neighbor);
      result.places.push_back(result.placeOf(site, sites.positions[neighbor]));
    }
    result.offsets.push_back(result.neighbors.size());
  }
  return result;
}

}  // namespace stipple
