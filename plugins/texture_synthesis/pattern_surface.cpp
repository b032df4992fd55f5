#include "plugins/texture_synthesis/pattern_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "core/error.h"

namespace stipple {

namespace {

constexpr double kMostDoublings = 2;  // up to 4 times the size and down to a quarter
constexpr double kMostLength = 3;     // of a direction: up to 4 times as long as wide
constexpr double kLeastLength = 1e-6;

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

// By how much a direction draws the pattern out, at least 1, and along which unit vector.
struct Stretch {
  double factor = 1;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
};

Stretch stretchBy(const Eigen::Vector3f& direction, const Eigen::Vector3f& normal) {
  if (!direction.allFinite()) return {};
  const Eigen::Vector3d along = (direction - direction.dot(normal) * normal).cast<double>();
  const double length = along.norm();
  if (!(length > kLeastLength)) return {};
  return {.factor = 1 + std::min(length, kMostLength), .axis = along / length};
}

// The squared scale, times the factor along the axis and divided by it across.
SparseMatrix assembleDirected(PatternSurface& surface, std::span<const Eigen::Vector3f> directions,
                              std::span<const double> squaredScale, const Progress* progress) {
  const Discretization& d = surface.discretization;
  std::vector<Eigen::Matrix3d> tensor(d.size());
  for (Index s = 0; s < d.size(); ++s) {
    const Stretch stretch = stretchBy(directions[d.sites.pointOfSite[s]], d.normals[s]);
    tensor[s] =
        squaredScale[s] * (Eigen::Matrix3d::Identity() / stretch.factor +
                           (stretch.factor - 1 / stretch.factor) * stretch.axis * stretch.axis.transpose());
    surface.finest = std::min(surface.finest, std::sqrt(squaredScale[s] / stretch.factor));
  }
  return assembleStiffness(d, tensor, progress);
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
  const bool hasTriangles =
      !d.meshTriangles.empty() || std::any_of(d.fans.flags.begin(), d.fans.flags.end(),
                                              [](std::uint8_t f) { return (f & Fans::kGapAfter) == 0; });
  if (!hasTriangles || !(surface.spacing > 0)) {
    throw InvalidInput("a pattern needs a surface: " + std::to_string(d.size()) +
                       " distinct points span no triangle");
  }
  return surface;
}

void guideDiffusion(PatternSurface& surface, const PointSet& points, const PatternGuides& guides,
                    const Progress* progress) {
  const Discretization& d = surface.discretization;
  std::vector<double> squaredScale(d.size(), 1);
  if (!guides.sizeBy.empty()) {
    squaredScale = readDoublings(points, d.sites, guides.sizeBy);
    for (double& value : squaredScale) value = std::exp2(2 * value);
  }
  surface.finest = std::sqrt(*std::min_element(squaredScale.begin(), squaredScale.end()));
  SparseMatrix stiffness;
  if (!guides.directionBy.empty()) {
    stiffness =
        assembleDirected(surface, points.values<Eigen::Vector3f>(guides.directionBy), squaredScale, progress);
  } else if (!guides.sizeBy.empty()) {
    stiffness = assembleStiffness(d, squaredScale, EdgeMean::kArithmetic, progress);
  } else {
    stiffness = assembleStiffness(d, progress);
  }
  surface.diffusion = std::make_unique<PairDiffusion>(stiffness, d.mass, surface.spacing);
}

}  // namespace stipple
