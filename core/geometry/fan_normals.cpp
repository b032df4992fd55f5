#include "core/geometry/fan_normals.h"

#include <Eigen/Geometry>

#include "core/parallel.h"

namespace stipple {

std::vector<Eigen::Vector3f> fanNormals(const Fans& fans, const Eigen::MatrixXd& places,
                                        std::span<const Eigen::Vector3f> along, const Progress* progress) {
  std::vector<Eigen::Vector3f> normals(fans.size());
  parallelFor(
      fans.size(), 4096,
      [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
          const auto spokes = fans.of(i);
          const auto flags = fans.flagsOf(i);
          Eigen::Vector3d sum = Eigen::Vector3d::Zero();
          for (std::size_t s = 0; s < spokes.size(); ++s) {
            if (flags[s] & Fans::kGapAfter) continue;
            const Index a = spokes[s], b = spokes[s + 1 == spokes.size() ? 0 : s + 1];
            const Eigen::Vector3d toA = places.row(a) - places.row(i), toB = places.row(b) - places.row(i);
            sum += toA.cross(toB);
          }
          Eigen::Vector3f normal = sum.stableNormalized().cast<float>();
          if (!(normal.squaredNorm() > 0.5f)) normal = along[i];
          normals[i] = normal.dot(along[i]) < 0 ? Eigen::Vector3f(-normal) : normal;
        }
      },
      progress);
  return normals;
}

}  // namespace stipple
