#include "app/tools/inspect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/fem/assembly.h"
#include "core/geometry/creases.h"

namespace stipple {

namespace {

// A fan looks at up to 64 neighbors, and so do those of its own neighbors, with which it has to agree.
constexpr std::size_t kFirst = 1024, kMost = 65536, kGrowth = 4;
// Copies of one place do not count as surroundings.
constexpr Index kLeastSites = 128;

using Near = std::pair<float, Index>;  // squared distance, row

// The nearest rows, itself among them; equal distances by row. What is not finite is nowhere.
std::vector<Near> findNearestRows(const PointSet& points, Index row, std::size_t count) {
  constexpr std::size_t kBlock = 1 << 17;
  const std::span<const Eigen::Vector3f> positions = points.positions();
  const auto keepNearest = [&](std::vector<Near>& near) {
    if (near.size() <= count) return;
    std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    near.resize(count);
  };
  std::vector<std::vector<Near>> parts((positions.size() + kBlock - 1) / kBlock);
  parallelFor(positions.size(), kBlock, [&](std::size_t begin, std::size_t end) {
    std::vector<Near>& part = parts[begin / kBlock];
    for (auto other = static_cast<Index>(begin); other < end; ++other) {
      const float squared = (positions[other] - positions[row]).squaredNorm();
      if (std::isfinite(squared)) part.emplace_back(squared, other);
    }
    keepNearest(part);
  });
  std::vector<Near> near;
  for (const auto& part : parts) near.insert(near.end(), part.begin(), part.end());
  keepNearest(near);
  std::sort(near.begin(), near.end());
  return near;
}

// A part of a point set, as a point set of its own.
struct Surroundings {
  std::vector<Index> rows;  // ascending, so that of several rows at a place the first stays the first
  PointSet points;

  Surroundings(const PointSet& whole, std::span<const Near> near) {
    for (const auto& [squared, row] : near) rows.push_back(row);
    std::sort(rows.begin(), rows.end());
    std::vector<Eigen::Vector3f> positions;
    for (const Index row : rows) positions.push_back(whole.positions()[row]);
    points = PointSet(std::move(positions));
  }
  Index placeOf(Index row) const {
    return static_cast<Index>(std::ranges::lower_bound(rows, row) - rows.begin());
  }
};

// What the discretization of the surroundings says.
class Inspector {
 public:
  Inspector(const PointSet& whole, Index row, const Surroundings& around, const Discretization& d)
      : whole_(whole), row_(row), around_(around), d_(d), site_(d.sites.siteOfPoint[around.placeOf(row)]) {}

  void addFan(PointInspection& inspection) const;
  void addMatrixRow(PointInspection& inspection) const;

 private:
  Index rowOf(Index site) const { return around_.rows[d_.sites.pointOfSite[site]]; }

  const PointSet& whole_;
  Index row_;
  const Surroundings& around_;
  const Discretization& d_;
  Index site_;
};

void Inspector::addFan(PointInspection& inspection) const {
  Eigen::Vector3f normal = d_.normals[site_];
  Eigen::Index largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  float sense = normal[largest];
  const Attribute* given = whole_.find("normal");
  if (given && given->type() == AttributeType::kVector3) {
    const float agreement = normal.dot(given->column.view<Eigen::Vector3f>()[row_]);
    if (agreement != 0 && std::isfinite(agreement)) sense = agreement;
  }
  const bool isTurned = sense < 0;
  inspection.normal = isTurned ? Eigen::Vector3f(-normal) : normal;

  const auto spokes = d_.fans.of(site_);
  const auto flags = d_.fans.flagsOf(site_);
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    if (flags[s] & Fans::kGapAfter) continue;
    const Index a = rowOf(spokes[s]), b = rowOf(spokes[s + 1 == spokes.size() ? 0 : s + 1]);
    inspection.fan.push_back(isTurned ? Triangle{rowOf(site_), b, a} : Triangle{rowOf(site_), a, b});
  }
  if (isTurned) std::ranges::reverse(inspection.fan);
  inspection.isOpen = d_.fans.open[site_] != 0;
  inspection.isCertified = d_.fans.certified[site_] != 0;
  inspection.isResolved = d_.resolved[site_] != 0;
  inspection.mass = d_.mass[site_];
}

void Inspector::addMatrixRow(PointInspection& inspection) const {
  const SparseMatrix stiffness = assembleStiffness(d_);
  for (SparseMatrix::InnerIterator entry(stiffness, static_cast<Eigen::Index>(site_)); entry; ++entry)
    inspection.matrixRow.push_back({rowOf(static_cast<Index>(entry.col())), entry.value()});
  std::ranges::sort(inspection.matrixRow, {}, &MatrixEntry::column);
}

// What needs no fans: moments of the nearest neighbors, and the turning to the corners of the fan.
void addShape(const Surroundings& around, PointInspection& inspection, const Progress* progress) {
  const Sites sites = weldAndOrder(around.points.positions());
  const Index site = sites.siteOfPoint[around.placeOf(inspection.row)];
  const Neighborhoods all = findNeighborhoods(sites, {}, progress);
  for (const Index neighbor : all.of(site))
    inspection.neighbors.push_back(around.rows[sites.pointOfSite[neighbor]]);
  inspection.moments = fitMoments(sites, all, progress)[site];
  inspection.classifier = classify({inspection.moments}).front();

  const std::vector<OneSidedPlane> planes = fitOneSidedPlanes(sites, {}, progress);
  for (const Triangle& t : inspection.fan) {
    for (const Index corner : {t[1], t[2]}) {
      const Index place = around.placeOf(corner);
      if (place == around.rows.size() || around.rows[place] != corner) continue;
      const double turn = turningAngle(planes[site], planes[sites.siteOfPoint[place]]);
      inspection.steepestTurn = std::max(inspection.steepestTurn, static_cast<float>(turn));
    }
  }
}

bool isNear(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

// But for rounding: the order of sums follows that of the sites.
bool agree(const PointInspection& a, const PointInspection& b) {
  const auto sameEntry = [](const MatrixEntry& x, const MatrixEntry& y) {
    return x.column == y.column && isNear(x.value, y.value);
  };
  auto fanA = a.fan, fanB = b.fan;
  std::ranges::sort(fanA);
  std::ranges::sort(fanB);
  return fanA == fanB && a.neighbors == b.neighbors &&
         std::ranges::equal(a.matrixRow, b.matrixRow, sameEntry) && isNear(a.mass, b.mass) &&
         a.isOpen == b.isOpen && a.isCertified == b.isCertified && a.isResolved == b.isResolved &&
         std::abs(a.steepestTurn - b.steepestTurn) < 1e-4f;
}

// discretize reports through a progress of its own.
class OnlyCancel final : public Progress {
 public:
  explicit OnlyCancel(const Progress* asked) : asked_(asked) {}
  void report(double, std::string_view) override {}
  void publish(const PointSet&) override {}
  bool cancelled() const override { return asked_ && asked_->cancelled(); }

 private:
  const Progress* asked_;
};

PointInspection inspectNearest(const PointSet& points, Index row, std::span<const Near> near,
                               const DiscretizationOptions& options, Progress& progress) {
  const Surroundings around(points, near);
  const Discretization d = discretize(around.points, options, progress);
  PointInspection inspection{.row = row, .position = points.positions()[row]};
  const Inspector inspector(points, row, around, d);
  inspector.addFan(inspection);
  inspector.addMatrixRow(inspection);
  inspection.isSettled = d.size() >= kLeastSites;
  return inspection;
}

// Looks farther and farther around until nothing changes, or there is no more. `near` is extended.
PointInspection inspectUntilSettled(const PointSet& points, Index row, std::vector<Near>& near,
                                    const DiscretizationOptions& options, Progress& progress) {
  std::size_t count = std::min(kFirst, near.size());
  PointInspection inspection = inspectNearest(points, row, std::span(near).first(count), options, progress);
  while (count < kMost) {
    const std::size_t wider = count * kGrowth;
    if (near.size() < wider) near = findNearestRows(points, row, wider);
    if (near.size() == count) {
      inspection.isSettled = true;
      return inspection;
    }
    count = std::min(wider, near.size());
    PointInspection next = inspectNearest(points, row, std::span(near).first(count), options, progress);
    const bool isSettled = inspection.isSettled && agree(inspection, next);
    inspection = std::move(next);
    if (isSettled) return inspection;
  }
  inspection.isSettled = false;
  return inspection;
}

}  // namespace

PointInspection inspectPoint(const PointSet& points, Index row, const DiscretizationOptions& options,
                             const Progress* progress) {
  if (row >= points.size())
    throw InvalidInput(fmt::format("there is no row {}, expected below {}", row, points.size()));
  if (!points.positions()[row].allFinite())
    throw InvalidInput(fmt::format("position[{}] is not finite", row));

  OnlyCancel cancel(progress);
  std::vector<Near> near = findNearestRows(points, row, kFirst * kGrowth);
  PointInspection inspection = inspectUntilSettled(points, row, near, options, cancel);
  addShape({points, std::span(near).first(std::min(kFirst * kGrowth, near.size()))}, inspection, progress);
  return inspection;
}

}  // namespace stipple
