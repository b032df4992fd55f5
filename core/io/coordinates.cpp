#include "core/io/coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"

namespace stipple {

namespace {

constexpr std::size_t kGrain = 1 << 16;
constexpr double kTolerance = 1e-6;  // of the extent, the promise of the origin rule

struct Survey {
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d high = -low;
  double loss = 0;  // largest rounding error of a float
};

bool fitsFloat(const Eigen::Vector3d& point) {
  return point.allFinite() && point.cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max();
}

Survey survey(std::span<const Eigen::Vector3d> coordinates) {
  std::vector<Survey> parts((coordinates.size() + kGrain - 1) / kGrain);
  parallelFor(coordinates.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    Survey part;
    for (std::size_t row = begin; row < end; ++row) {
      const Eigen::Vector3d& point = coordinates[row];
      if (!fitsFloat(point)) continue;
      part.low = part.low.min(point.array());
      part.high = part.high.max(point.array());
      part.loss = std::max(part.loss, (point.cast<float>().cast<double>() - point).cwiseAbs().maxCoeff());
    }
    parts[begin / kGrain] = part;
  });
  Survey whole;
  for (const Survey& part : parts) {
    whole.low = whole.low.min(part.low);
    whole.high = whole.high.max(part.high);
    whole.loss = std::max(whole.loss, part.loss);
  }
  return whole;
}

}  // namespace

Eigen::Vector3d chooseOrigin(std::span<const Eigen::Vector3d> coordinates) {
  const Survey found = survey(coordinates);
  if (!(found.low <= found.high).all()) return Eigen::Vector3d::Zero();
  const double extent = (found.high - found.low).maxCoeff();
  if (found.loss <= kTolerance * extent) return Eigen::Vector3d::Zero();
  // A step of about an eighth of the extent keeps the rest within 0.6 extents; for a single place, the finest
  // step that is far above the resolution of the doubles.
  const double largest = std::max(found.low.abs().maxCoeff(), found.high.abs().maxCoeff());
  const double step = std::exp2(std::ceil(std::log2(std::max(extent / 8, std::ldexp(largest, -40)))));
  return ((found.low + found.high) / (2 * step)).round() * step;
}

std::vector<Eigen::Vector3f> relativeTo(const Eigen::Vector3d& origin,
                                        std::span<const Eigen::Vector3d> coordinates) {
  std::vector<Eigen::Vector3f> positions(coordinates.size());
  constexpr double kLargest = std::numeric_limits<float>::max();
  parallelFor(coordinates.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const Eigen::Vector3d rest = coordinates[row] - origin;
      positions[row] = (rest.array().abs() <= kLargest)
                           .select(rest.array(), std::numeric_limits<double>::quiet_NaN())
                           .cast<float>();
    }
  });
  return positions;
}

std::vector<Index> rowsNotFinite(std::span<const Eigen::Vector3f> positions) {
  std::vector<std::vector<Index>> parts((positions.size() + kGrain - 1) / kGrain);
  parallelFor(positions.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      // 0 * infinity and 0 * NaN are NaN: one test for three numbers.
      const Eigen::Vector3f& p = positions[row];
      const float zero = (p.x() + p.y() + p.z()) * 0.0F;
      if (zero != 0.0F && !p.allFinite()) parts[begin / kGrain].push_back(static_cast<Index>(row));
    }
  });
  std::vector<Index> rows;
  for (const auto& part : parts) rows.insert(rows.end(), part.begin(), part.end());
  return rows;
}

}  // namespace stipple
