#include "core/geometry/sites.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "core/error.h"
#include "core/geometry/morton.h"

namespace stipple {

namespace {

struct CodedRow {
  std::uint64_t code;
  Index row;
};

// Stable radix sort by code, 11 bits a pass; a pass in which all rows share the digit is skipped.
void sortByCode(std::vector<CodedRow>& rows) {
  constexpr int kDigitBits = 11, kDigits = 1 << kDigitBits;
  std::vector<CodedRow> other(rows.size());
  for (int shift = 0; shift < 3 * MortonLattice::kBits; shift += kDigitBits) {
    std::array<std::size_t, kDigits> start{};
    for (const CodedRow& r : rows) ++start[(r.code >> shift) & (kDigits - 1)];
    if (std::ranges::find(start, rows.size()) != start.end()) continue;
    std::exclusive_scan(start.begin(), start.end(), start.begin(), std::size_t{0});
    for (const CodedRow& r : rows) other[start[(r.code >> shift) & (kDigits - 1)]++] = r;
    rows.swap(other);
  }
}

// Rows of one lattice cell: by position, so that equal places are adjacent whatever the order of the file.
void sortCells(std::vector<CodedRow>& rows, std::span<const Eigen::Vector3f> positions) {
  const auto key = [&](const CodedRow& r) {
    const Eigen::Vector3f& p = positions[r.row];
    return std::make_tuple(p.x(), p.y(), p.z(), r.row);
  };
  for (std::size_t begin = 0; begin < rows.size();) {
    std::size_t end = begin + 1;
    while (end < rows.size() && rows[end].code == rows[begin].code) ++end;
    if (end - begin > 1) {
      std::sort(rows.begin() + static_cast<std::ptrdiff_t>(begin),
                rows.begin() + static_cast<std::ptrdiff_t>(end),
                [&](const CodedRow& a, const CodedRow& b) { return key(a) < key(b); });
    }
    begin = end;
  }
}

void requireFinite(std::span<const Eigen::Vector3f> positions) {
  const auto found = std::ranges::find_if(positions, [](const auto& p) { return !p.allFinite(); });
  if (found == positions.end()) return;
  throw InvalidInput(fmt::format("position[{}] is ({}, {}, {}), expected finite coordinates",
                                 found - positions.begin(), found->x(), found->y(), found->z()));
}

}  // namespace

Sites weldAndOrder(std::span<const Eigen::Vector3f> positions) {
  requireFinite(positions);
  const MortonLattice lattice = fitMortonLattice(positions);
  std::vector<CodedRow> rows(positions.size());
  parallelFor(rows.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) rows[i] = {lattice.codeOf(positions[i]), static_cast<Index>(i)};
  });
  sortByCode(rows);
  sortCells(rows, positions);

  Sites sites;
  sites.siteOfPoint.resize(positions.size());
  sites.positions.reserve(positions.size());
  sites.pointOfSite.reserve(positions.size());
  for (const CodedRow& r : rows) {
    if (sites.positions.empty() || sites.positions.back() != positions[r.row]) {
      sites.positions.push_back(positions[r.row]);
      sites.pointOfSite.push_back(r.row);
    }
    sites.siteOfPoint[r.row] = sites.size() - 1;
  }
  return sites;
}

void requireUsableScale(const Sites& sites) {
  if (sites.size() < 2) return;
  // A few thousand steps along the spatial order give the size of the spacing.
  const std::size_t steps = std::min<std::size_t>(sites.size() - 1, 4096);
  std::vector<double> lengths(steps);
  for (std::size_t s = 0; s < steps; ++s) {
    const std::size_t site = s * (sites.size() - 1) / steps;
    lengths[s] = (sites.positions[site + 1].cast<double>() - sites.positions[site].cast<double>()).norm();
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(steps / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  constexpr double kLeast = 1e-15, kMost = 1e15;
  if (*middle < kLeast || *middle > kMost) {
    throw InvalidInput(fmt::format("the points lie about {:.2g} apart, expected {:g} to {:g}: scale them",
                                   *middle, kLeast, kMost));
  }
}

}  // namespace stipple
