#include "app/tools/measure.h"

#include <glm/geometric.hpp>

namespace stipple {

Measurement measure(const SurfaceDistance& surface, const glm::vec3& from, const glm::vec3& to) {
  Measurement measurement{.straight = glm::distance(glm::dvec3(from), glm::dvec3(to))};
  const Index start = surface.findNearest({from.x, from.y, from.z});
  const Index end = surface.findNearest({to.x, to.y, to.z});
  const std::vector<Index> sites = surface.findPath(start, end);
  if (sites.empty()) return measurement;

  // The places themselves stand for the sites nearest to them.
  measurement.path.push_back(from);
  for (std::size_t s = 1; s + 1 < sites.size(); ++s) {
    const Eigen::Vector3f& p = surface.sites().positions[sites[s]];
    measurement.path.emplace_back(p.x(), p.y(), p.z());
  }
  measurement.path.push_back(to);
  double length = 0;
  for (std::size_t p = 1; p < measurement.path.size(); ++p)
    length += glm::distance(glm::dvec3(measurement.path[p - 1]), glm::dvec3(measurement.path[p]));
  measurement.alongSurface = length;
  return measurement;
}

}  // namespace stipple
