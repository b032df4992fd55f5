#include "plugins/inpainting/relief.h"

#include <cmath>
#include <numeric>

#include "core/geometry/fan_normals.h"
#include "core/geometry/orientation.h"

namespace stipple {

namespace {

constexpr int kFirstHeight = 8;
// Rounds of averaging over fans; their reach grows as the square root: 1, 2 and 4 spacings.
constexpr int kRounds[] = {1, 4, 16};

void averageOverFans(const Fans& fans, const std::vector<Eigen::Vector3d>& from,
                     std::vector<Eigen::Vector3d>& to, const Progress* progress) {
  parallelFor(
      fans.size(), 2048,
      [&](std::size_t begin, std::size_t end) {
        for (auto site = static_cast<Index>(begin); site < end; ++site) {
          Eigen::Vector3d sum = from[site];
          for (const Index neighbor : fans.of(site)) sum += from[neighbor];
          to[site] = sum / static_cast<double>(fans.of(site).size() + 1);
        }
      },
      progress);
}

// Those of the fans, averaged over fans once: finer than planes through many neighbors, which round hollows
// off, and steadier than single fans.
std::vector<Eigen::Vector3d> fineNormals(const Discretization& d, const Progress* progress) {
  Eigen::MatrixXd places(d.size(), 3);
  for (Index i = 0; i < d.size(); ++i) places.row(i) = d.sites.positions[i].cast<double>().transpose();
  const std::vector<Eigen::Vector3f> oriented = orientNormals(d, PointSet(), progress).normals;
  std::vector<Eigen::Vector3d> normals, averaged(d.size());
  for (const Eigen::Vector3f& n : fanNormals(d.fans, places, oriented, progress))
    normals.push_back(n.cast<double>());
  averageOverFans(d.fans, normals, averaged, progress);
  for (Eigen::Vector3d& n : averaged) n.normalize();
  return averaged;
}

// n . (x - mean) / (h sqrt(rounds)), h the mean spacing: of one size at every scale on rough surfaces.
void describeHeights(const Discretization& d, std::span<const Eigen::Vector3d> normals, Relief& relief,
                     const Progress* progress) {
  const double area = std::accumulate(d.mass.begin(), d.mass.end(), 0.0);
  const double spacing = std::sqrt(area / std::max<double>(d.size(), 1));
  std::vector<Eigen::Vector3d> means, next(d.size());
  for (const Eigen::Vector3f& p : d.sites.positions) means.push_back(p.cast<double>());
  int rounds = 0, column = kFirstHeight;
  for (const int wanted : kRounds) {
    for (; rounds < wanted; ++rounds) {
      averageOverFans(d.fans, means, next, progress);
      means.swap(next);
    }
    for (Index i = 0; i < d.size(); ++i) {
      const Eigen::Vector3d out = d.sites.positions[i].cast<double>() - means[i];
      relief(i, column) = normals[i].dot(out) / (spacing * std::sqrt(wanted));
    }
    ++column;
  }
}

}  // namespace

Relief describeRelief(const Discretization& d, const Progress* progress) {
  Relief relief(d.size(), kReliefSize);
  const std::vector<Eigen::Vector3d> normals = fineNormals(d, progress);
  for (Index i = 0; i < d.size(); ++i) {
    const Eigen::Vector3d& n = normals[i];
    relief.row(i).head<kFirstHeight>() << n.x(), n.y(), n.z(), n.x() * n.y(), n.y() * n.z(), n.z() * n.x(),
        n.x() * n.x() - n.y() * n.y(), 3 * n.z() * n.z() - 1;
  }
  describeHeights(d, normals, relief, progress);
  return relief;
}

}  // namespace stipple
