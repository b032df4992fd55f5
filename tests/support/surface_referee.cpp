#include "tests/support/surface_referee.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>

namespace stipple {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Traits = CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>;

}  // namespace

struct SurfaceReferee::Tree {
  Triangles triangles;
  CGAL::AABB_tree<Traits> tree;
};

SurfaceReferee::SurfaceReferee(const PointSet& mesh) : tree_(std::make_unique<Tree>()) {
  const auto at = [&](Index row) {
    const Eigen::Vector3f& p = mesh.positions()[row];
    return Kernel::Point_3(p.x(), p.y(), p.z());
  };
  for (const Triangle& t : mesh.triangles()) {
    const Kernel::Triangle_3 triangle(at(t[0]), at(t[1]), at(t[2]));
    if (!triangle.is_degenerate()) tree_->triangles.push_back(triangle);
  }
  tree_->tree.insert(tree_->triangles.begin(), tree_->triangles.end());
  tree_->tree.accelerate_distance_queries();
}

SurfaceReferee::~SurfaceReferee() = default;

double SurfaceReferee::distanceTo(const Eigen::Vector3d& place) const {
  return std::sqrt(tree_->tree.squared_distance({place.x(), place.y(), place.z()}));
}

}  // namespace stipple
