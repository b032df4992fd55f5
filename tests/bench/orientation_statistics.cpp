// Share of sites whose normal has another sign than the faces of the file give it, for scans whose faces wind
// consistently. The sign of a whole connected part counts too.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>

#include "core/geometry/orientation.h"
#include "core/io/point_io.h"
#include "core/stopwatch.h"

namespace stipple {
namespace {

// No directed edge is in two faces.
bool windsConsistently(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t c = 0; c < 3; ++c) edges.emplace_back(t[c], t[(c + 1) % 3]);
  }
  std::ranges::sort(edges);
  return std::ranges::adjacent_find(edges) == edges.end();
}

void printRow(const std::string& name, PointSet points) {
  points.erase("normal");
  Progress progress;
  const Discretization d = discretize(points, {}, progress);
  const Stopwatch watch;
  const Orientation orientation = orientNormals(d, points);
  const double seconds = watch.seconds();

  std::vector<Eigen::Vector3d> sums(d.size(), Eigen::Vector3d::Zero());
  std::vector<Triangle> triangles = points.triangles();
  const auto p = points.positions();
  for (Triangle& t : triangles) {
    const Eigen::Vector3d cross = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).cast<double>();
    for (Index& corner : t) {
      corner = d.sites.siteOfPoint[corner];
      sums[corner] += cross;
    }
  }
  Index compared = 0, wrong = 0;
  for (Index i = 0; i < d.size(); ++i) {
    compared += !sums[i].isZero();
    wrong += orientation.normals[i].cast<double>().dot(sums[i]) < 0;
  }
  const double share = 100.0 * wrong / std::max<Index>(compared, 1);
  fmt::print("{:<34}{:>9}{:>8}{:>9.3f}{:>14.3f}{:>11}{:>9.3f}  {}\n", name, d.size(), wrong, share,
             std::min(share, 100 - share), orientation.conflicts, seconds,
             windsConsistently(triangles) ? "" : "faces do not wind consistently");
}

}  // namespace
}  // namespace stipple

int main() {
  using namespace stipple;
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(STIPPLE_TEST_DATA)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".ply" || extension == ".obj" || extension == ".off") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  fmt::print("{:<34}{:>9}{:>8}{:>9}{:>14}{:>11}{:>9}\n", "file", "sites", "wrong", "%", "% up to sign",
             "conflicts", "wall s");
  Progress progress;
  for (const fs::path& file : files) {
    PointSet points = readPoints(file, progress).points;
    if (!points.triangles().empty()) printRow(file.filename().string(), std::move(points));
  }
}
