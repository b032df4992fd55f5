#include "plugins/inpainting/surround.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <unordered_map>

#include "core/geometry/nearest_points.h"
#include "core/points/field.h"

namespace stipple {

namespace {

// Lengths in spacings. Parts of the mask whose cells touch are one part.
constexpr float kCell = 8;
// A part has at most this many cells: 400 whole ones hold 26000 points.
constexpr std::size_t kMostCells = 400;
// How far the surroundings reach: this many radii of the part, within bounds. A patch is 7 wide.
constexpr float kReachInRadii = 1.5f, kLeastReach = 24, kMostReach = 80;

using Cell = std::array<int, 3>;

// Cells of a lattice; what lies farther than cells can be counted is in a cell at the end.
struct Lattice {
  Eigen::Vector3f corner;
  float size;
  Cell cellOf(const Eigen::Vector3f& position) const {
    const Eigen::Array3i cell = ((position - corner) / size).array().floor().max(-1e9f).min(1e9f).cast<int>();
    return {cell[0], cell[1], cell[2]};
  }
};

// Calls body(cell) for those at most `layers` away.
template <class Body>
void forCellsAround(const Cell& cell, int layers, const Body& body) {
  for (int z = -layers; z <= layers; ++z) {
    for (int y = -layers; y <= layers; ++y) {
      for (int x = -layers; x <= layers; ++x) body(Cell{cell[0] + x, cell[1] + y, cell[2] + z});
    }
  }
}

using CellMembers = std::map<Cell, std::vector<Index>>;

std::vector<std::vector<Cell>> connectedCells(const CellMembers& members) {
  std::vector<std::vector<Cell>> parts;
  std::map<Cell, bool> isSeen;
  for (const auto& [start, ignored] : members) {
    if (isSeen[start]) continue;
    std::vector<Cell> part{start};
    isSeen[start] = true;
    for (std::size_t next = 0; next < part.size(); ++next) {
      forCellsAround(Cell(part[next]), 1, [&](const Cell& cell) {
        if (!members.contains(cell) || isSeen[cell]) return;
        isSeen[cell] = true;
        part.push_back(cell);
      });
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

// Cuts at the median along the longest side until every part is small enough.
void cutLargeParts(std::vector<std::vector<Cell>>& parts) {
  for (std::size_t p = 0; p < parts.size();) {
    if (parts[p].size() <= kMostCells) {
      ++p;
      continue;
    }
    std::array<int, 3> extent{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto [least, greatest] = std::ranges::minmax(
          parts[p], {}, [axis](const Cell& cell) { return cell[static_cast<std::size_t>(axis)]; });
      extent[axis] = greatest[axis] - least[axis];
    }
    const auto axis = static_cast<std::size_t>(std::ranges::max_element(extent) - extent.begin());
    std::ranges::sort(parts[p], [axis](const Cell& a, const Cell& b) {
      return a[axis] != b[axis] ? a[axis] < b[axis] : a < b;
    });
    const auto middle = parts[p].begin() + static_cast<std::ptrdiff_t>(parts[p].size() / 2);
    std::vector<Cell> half(middle, parts[p].end());
    parts[p].erase(middle, parts[p].end());
    parts.push_back(std::move(half));
  }
}

// Greatest distance of a target to what is known.
float radiusOf(const Hole& hole, const NearestPoint& known, std::span<const Index> knownSites,
               std::span<const Index> targets) {
  const std::vector<Eigen::Vector3f>& positions = hole.discretization.sites.positions;
  float radius = 0;
  for (const Index site : targets)
    radius = std::max(radius, (positions[knownSites[known.find(positions[site])]] - positions[site]).norm());
  return radius;
}

struct CellHash {
  std::size_t operator()(const Cell& c) const {
    const auto mixed = static_cast<std::uint64_t>(c[0]) * 0x9e3779b97f4a7c15u ^
                       static_cast<std::uint64_t>(c[1]) * 0xc2b2ae3d27d4eb4fu ^
                       static_cast<std::uint64_t>(c[2]) * 0x165667b19e3779f9u;
    return mixed ^ (mixed >> 29);
  }
};
using PartsOfCell = std::unordered_map<Cell, std::vector<Index>, CellHash>;

// In one pass over all rows, each part takes those in its cells.
void takeRows(const PointSet& points, const Lattice& lattice, const PartsOfCell& partsOfCell,
              std::vector<MaskPart>& parts, const Progress* progress) {
  constexpr std::size_t kBlock = 1 << 15;
  const std::span<const Eigen::Vector3f> positions = points.positions();
  std::vector<std::vector<std::pair<Index, Index>>> found((positions.size() + kBlock - 1) / kBlock);
  parallelFor(
      positions.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
          const auto place = partsOfCell.find(lattice.cellOf(positions[row]));
          if (place == partsOfCell.end()) continue;
          for (const Index part : place->second)
            found[begin / kBlock].emplace_back(part, static_cast<Index>(row));
        }
      },
      progress);
  for (const auto& block : found) {
    for (const auto& [part, row] : block) parts[part].rows.push_back(row);
  }
}

}  // namespace

std::vector<MaskPart> splitMask(const PointSet& points, const Hole& hole, std::span<const Index> targets,
                                float spacing, const Progress* progress) {
  if (targets.empty()) return {};
  const std::vector<Eigen::Vector3f>& positions = hole.discretization.sites.positions;
  const Lattice lattice{.corner = positions[targets.front()], .size = kCell * spacing};
  CellMembers members;
  for (const Index site : targets) members[lattice.cellOf(positions[site])].push_back(site);
  std::vector<std::vector<Cell>> cells = connectedCells(members);
  cutLargeParts(cells);

  std::vector<Index> knownSites;
  std::vector<Eigen::Vector3f> knownPositions;
  for (Index site = 0; site < hole.discretization.size(); ++site) {
    if (std::ranges::binary_search(hole.unknown, site)) continue;
    knownSites.push_back(site);
    knownPositions.push_back(positions[site]);
  }
  if (knownSites.empty()) return {};
  const NearestPoint known(knownPositions);

  std::vector<MaskPart> parts(cells.size());
  PartsOfCell partsOfCell;
  for (Index p = 0; p < parts.size(); ++p) {
    std::vector<Index>& sites = parts[p].targets;
    for (const Cell& cell : cells[p]) sites.insert(sites.end(), members[cell].begin(), members[cell].end());
    std::ranges::sort(sites);
    const float radius = radiusOf(hole, known, knownSites, sites) / spacing;
    const float reach = std::clamp(kReachInRadii * radius, kLeastReach, kMostReach);
    const int layers = static_cast<int>(std::ceil(reach / kCell));
    for (const Cell& cell : cells[p]) {
      forCellsAround(cell, layers, [&](const Cell& near) {
        std::vector<Index>& held = partsOfCell[near];
        if (held.empty() || held.back() != p) held.push_back(p);
      });
    }
    if (progress) progress->throwIfCancelled();
  }
  takeRows(points, lattice, partsOfCell, parts, progress);
  return parts;
}

Surround gatherSurround(const PointSet& points, const Attribute& attribute, const Region& region,
                        const Hole& hole, const MaskPart& part) {
  const Eigen::MatrixXd given = readField(attribute, part.rows);
  std::vector<Index> kept;  // places in part.rows
  std::vector<Eigen::Vector3f> positions;
  for (Index r = 0; r < part.rows.size(); ++r) {
    if (!region.contains(part.rows[r]) && !given.row(r).allFinite()) continue;
    kept.push_back(r);
    positions.push_back(points.positions()[part.rows[r]]);
  }
  Surround surround{.sites = weldAndOrder(positions)};
  const Index size = surround.sites.size();
  surround.kinds.assign(size, Surround::Kind::kOther);
  surround.holeSites.assign(size, 0);
  surround.values = Eigen::MatrixXd::Zero(size, given.cols());
  for (Index k = 0; k < kept.size(); ++k) {
    const Index site = surround.sites.siteOfPoint[k], row = part.rows[kept[k]];
    if (surround.kinds[site] == Surround::Kind::kKnown) continue;
    if (!region.contains(row)) {
      surround.kinds[site] = Surround::Kind::kKnown;
      surround.values.row(site) = given.row(kept[k]);
      continue;
    }
    const auto place = std::ranges::lower_bound(hole.maskedRows, row) - hole.maskedRows.begin();
    const Index holeSite = hole.siteOfRow[static_cast<std::size_t>(place)];
    surround.holeSites[site] = holeSite;
    surround.values.row(site) = hole.values.row(holeSite);
    if (std::ranges::binary_search(part.targets, holeSite)) surround.kinds[site] = Surround::Kind::kTarget;
  }
  return surround;
}

}  // namespace stipple
