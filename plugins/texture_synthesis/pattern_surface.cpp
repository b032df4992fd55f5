#include "plugins/texture_synthesis/pattern_surface.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "core/error.h"

namespace stipple {

namespace {

constexpr double kMostDoublings = 2;  // up to 4 times the size and down to a quarter
constexpr double kMostLength = 3;     // of a direction: up to 4 times as long as wide

const Attribute& require(const PointSet& points, const std::string& name) {
  const Attribute* found = points.find(name);
  if (!found) throw InvalidInput("there is no attribute \"" + name + "\"");
  return *found;
}

// By how many doublings the size changes at each site.
std::vector<double> readDoublings(const PointSet& points, const Sites& sites, const std::string& name) {
  std::vector<double> doublings(sites.size(), 0);
  std::visit(
      [&](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_arithmetic_v<Value>) {
          for (Index s = 0; s < sites.size(); ++s) {
            const auto value = static_cast<double>(values[sites.pointOfSite[s]]);
            if (std::isfinite(value)) doublings[s] = std::clamp(value, -kMostDoublings, kMostDoublings);
          }
        }
      },
      require(points, name).column.values());
  return doublings;
}

// 1 / stretch across the direction, stretch along it, times the square of the scale.
Eigen::Matrix3d drawnOut(const Eigen::Vector3f& direction, const Eigen::Vector3f& normal,
                         double squaredScale) {
  const Eigen::Matrix3d isotropic = squaredScale * Eigen::Matrix3d::Identity();
  if (!direction.allFinite()) return isotropic;
  const Eigen::Vector3d along = (direction - direction.dot(normal) * normal).cast<double>();
  const double length = along.norm();
  if (!(length > 1e-6)) return isotropic;
  const double stretch = 1 + std::min(length, kMostLength);
  const Eigen::Vector3d axis = along / length;
  return isotropic / stretch + squaredScale * (stretch - 1 / stretch) * axis * axis.transpose();
}

}  // namespace

void checkGuides(const PointSet& points, const PatternGuides& guides) {
  if (!guides.sizeBy.empty()) {
    const AttributeType type = require(points, guides.sizeBy).type();
    if (type == AttributeType::kVector3 || type == AttributeType::kColor) {
      throw InvalidInput("attribute \"" + guides.sizeBy + "\" is a " + nameOf(type) +
                         ", size_by must be a number");
    }
  }
  if (!guides.directionBy.empty()) {
    const AttributeType type = require(points, guides.directionBy).type();
    if (type != AttributeType::kVector3) {
      throw InvalidInput("attribute \"" + guides.directionBy + "\" is a " + nameOf(type) +
                         ", direction_by must be a vector");
    }
  }
}

PatternSurface buildPatternSurface(const PointSet& points, const DiscretizationOptions& options,
                                   Progress& progress) {
  PatternSurface surface{.discretization = discretize(points, options, progress)};
  const Discretization& d = surface.discretization;
  surface.area = std::accumulate(d.mass.begin(), d.mass.end(), 0.0);
  surface.spacing = std::sqrt(surface.area / std::max<double>(d.size(), 1));
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& x : d.sites.positions) box.extend(x);
  surface.diagonal = box.isEmpty() ? 0 : static_cast<double>(box.diagonal().norm());
  if (d.fans.neighbors.empty() || !(surface.spacing > 0)) {
    throw InvalidInput("a pattern needs a surface: " + std::to_string(d.size()) +
                       " distinct points span no triangle");
  }
  return surface;
}

void guideDiffusion(PatternSurface& surface, const PointSet& points, const PatternGuides& guides,
                    const Progress* progress) {
  const Discretization& d = surface.discretization;
  SparseMatrix stiffness;
  if (guides.sizeBy.empty() && guides.directionBy.empty()) {
    stiffness = assembleStiffness(d, progress);
  } else {
    std::vector<double> squaredScale(d.size(), 1);
    if (!guides.sizeBy.empty()) squaredScale = readDoublings(points, d.sites, guides.sizeBy);
    if (!guides.sizeBy.empty()) {
      for (double& value : squaredScale) value = std::exp2(2 * value);
    }
    if (guides.directionBy.empty()) {
      stiffness = assembleStiffness(d, squaredScale, EdgeMean::kArithmetic, progress);
    } else {
      const auto directions = points.values<Eigen::Vector3f>(guides.directionBy);
      std::vector<Eigen::Matrix3d> tensor(d.size());
      for (Index s = 0; s < d.size(); ++s) {
        tensor[s] = drawnOut(directions[d.sites.pointOfSite[s]], d.normals[s], squaredScale[s]);
      }
      stiffness = assembleStiffness(d, tensor, progress);
    }
  }
  surface.diffusion = std::make_unique<PairDiffusion>(stiffness, d.mass, surface.spacing);
}

}  // namespace stipple
