#include "core/fem/point_rows.h"

#include <algorithm>
#include <limits>

namespace stipple {

PointRows::PointRows(const Sites& sites, const SparseMatrix& stiffness)
    : sites_(sites), stiffness_(stiffness), begins_(sites.size() + 1, 0), copies_(sites.siteOfPoint.size()) {
  for (const Index site : sites.siteOfPoint) ++begins_[site + 1];
  for (Index s = 0; s < sites.size(); ++s) begins_[s + 1] += begins_[s];
  std::vector<Index> next(begins_.begin(), begins_.end() - 1);
  for (Index p = 0; p < size(); ++p) copies_[next[sites.siteOfPoint[p]]++] = p;
}

void PointRows::lowerRow(Index point, std::vector<Entry>& entries) const {
  entries.clear();
  const Index site = sites_.siteOfPoint[point];
  const auto copiesHere = static_cast<double>(copiesOf(site).size());
  for (SparseMatrix::InnerIterator entry(stiffness_, site); entry; ++entry) {
    const auto copies = copiesOf(static_cast<Index>(entry.col()));
    const double value = entry.value() / (copiesHere * static_cast<double>(copies.size()));
    for (const Index column : copies) {
      if (column > point) break;
      if (value != 0 || column == point) entries.emplace_back(column, value);
    }
  }
  std::sort(entries.begin(), entries.end());
}

std::size_t PointRows::countLower() const {
  std::size_t total = 0;
  for (Index site = 0; site < sites_.size(); ++site) {
    const auto here = copiesOf(site);
    for (SparseMatrix::InnerIterator entry(stiffness_, site); entry; ++entry) {
      const auto column = static_cast<Index>(entry.col());
      if (column == site) {
        total += entry.value() != 0 ? here.size() * (here.size() + 1) / 2 : here.size();
      } else if (column < site && entry.value() != 0) {
        // Each pair of copies stands in the lower triangle once, whichever comes first in the file.
        total += here.size() * copiesOf(column).size();
      }
    }
  }
  if (total > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw InvalidInput("too many points at one place: the matrix would have more than 2^31 entries");
  }
  return total;
}

std::vector<double> expandMassToPoints(const Sites& sites, std::span<const double> mass) {
  std::vector<double> copies(sites.size(), 0.0), expanded(sites.siteOfPoint.size());
  for (const Index site : sites.siteOfPoint) ++copies[site];
  for (std::size_t p = 0; p < expanded.size(); ++p) {
    expanded[p] = mass[sites.siteOfPoint[p]] / copies[sites.siteOfPoint[p]];
  }
  return expanded;
}

}  // namespace stipple
