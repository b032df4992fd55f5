// 1 M random points of a sphere in random order, to both matrices with consensus (bar: 8 processor seconds
// and 1 GB at the peak), beside what PCL and CGAL need for normals alone, k = 30, on the same points in the
// same run. Each method runs in a process of its own, so that each has a peak of its own.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/pca_estimate_normals.h>
#include <fmt/format.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/point_types.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <utility>

#include "core/fem/assembly.h"
#include "core/geometry/orientation.h"
#include "core/stopwatch.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

constexpr int kNeighbors = 30;

struct Cost {
  double seconds = 0, cpuSeconds = 0;
};

// What a method computed, so that a method that does nothing shows.
struct Report {
  Cost cost;
  std::size_t results = 0;
};

using Points = std::vector<Eigen::Vector3f>;
using Method = std::function<Report(const Points&)>;

Report discretizeWithMatrices(const Points& points) {
  const Stopwatch watch;
  Progress progress;
  const Discretization d = discretize(PointSet(points), {}, progress);
  const SparseMatrix stiffness = assembleStiffness(d);
  return {{watch.seconds(), watch.cpuSeconds()}, d.mass.size() + static_cast<std::size_t>(stiffness.rows())};
}

Report discretizeAndOrient(const Points& points) {
  const Stopwatch watch;
  Progress progress;
  const PointSet set(points);
  const Orientation orientation = orientNormals(discretize(set, {}, progress), set);
  return {{watch.seconds(), watch.cpuSeconds()}, orientation.normals.size()};
}

Report estimateByPcl(const Points& points) {
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3f& p : points) cloud->push_back({p.x(), p.y(), p.z()});
  const Stopwatch watch;
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setKSearch(kNeighbors);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);
  return {{watch.seconds(), watch.cpuSeconds()}, normals.size()};
}

Report estimateByCgal(const Points& points) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using PointAndNormal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
  std::vector<PointAndNormal> pairs;
  pairs.reserve(points.size());
  for (const Eigen::Vector3f& p : points) {
    pairs.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(0, 0, 0));
  }
  const Stopwatch watch;
  CGAL::pca_estimate_normals<CGAL::Parallel_if_available_tag>(
      pairs, kNeighbors,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<PointAndNormal>())
          .normal_map(CGAL::Second_of_pair_property_map<PointAndNormal>()));
  const Cost cost{watch.seconds(), watch.cpuSeconds()};
  std::size_t estimated = 0;
  for (const PointAndNormal& pair : pairs) estimated += pair.second != CGAL::NULL_VECTOR;
  return {cost, estimated};
}

void printRow(const char* name, const Method& method, const Points& points) {
  int ends[2];
  if (pipe(ends) != 0) throw IoError("no pipe to a child process");
  const pid_t child = fork();
  if (child < 0) throw IoError("no child process");
  if (child == 0) {
    const Report report = method(points);
    const bool sent = write(ends[1], &report, sizeof report) == sizeof report;
    _exit(sent ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  close(ends[1]);
  Report report;
  const bool received = read(ends[0], &report, sizeof report) == sizeof report;
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!received || status != 0) {
    fmt::print("{:<58} failed\n", name);
    return;
  }
  fmt::print("{:<58}{:>8.2f}{:>8.2f}{:>10.0f}{:>10}\n", name, report.cost.seconds, report.cost.cpuSeconds,
             static_cast<double>(usage.ru_maxrss) / 1024, report.results);
  std::fflush(stdout);
}

}  // namespace
}  // namespace stipple

// Usage: comparison_bench [number of points]
int main(int argc, char** argv) {
  using namespace stipple;
  const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const Points points = shapes::randomSphere(count);
  fmt::print("{} random points of the unit sphere in random order\n", count);
  fmt::print("{:<58}{:>8}{:>8}{:>10}{:>10}\n", "method", "wall s", "cpu s", "peak MiB", "results");
  std::fflush(stdout);
  printRow(
      "(the points alone)", [](const Points&) { return Report{}; }, points);
  printRow("Stipple: to stiffness and mass, with consensus", discretizeWithMatrices, points);
  printRow("Stipple: to oriented normals, with consensus", discretizeAndOrient, points);
  printRow("PCL NormalEstimationOMP, k = 30 (normals alone)", estimateByPcl, points);
  printRow("CGAL pca_estimate_normals, k = 30 (normals alone)", estimateByCgal, points);
}
