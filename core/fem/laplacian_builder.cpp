#include "core/fem/laplacian_builder.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace stipple {

namespace {

struct Entry {
  Index column;
  double weight;
};

// Rows of the strict lower triangle, columns ascending, equal columns added up.
struct LowerRows {
  std::vector<std::size_t> begins;
  std::vector<Index> counts;
  std::vector<Entry> entries;
};

LowerRows gatherLower(Index rows, const std::vector<WeightedEdge>& edges) {
  LowerRows lower;
  lower.begins.assign(rows + 1, 0);
  for (const WeightedEdge& e : edges) ++lower.begins[std::max(e.i, e.j) + 1];
  std::partial_sum(lower.begins.begin(), lower.begins.end(), lower.begins.begin());
  std::vector<std::size_t> next(lower.begins.begin(), lower.begins.end() - 1);
  lower.entries.resize(edges.size());
  for (const WeightedEdge& e : edges)
    lower.entries[next[std::max(e.i, e.j)]++] = {std::min(e.i, e.j), e.weight};

  lower.counts.assign(rows, 0);
  parallelFor(rows, 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      Entry* const first = lower.entries.data() + lower.begins[row];
      Entry* const last = lower.entries.data() + lower.begins[row + 1];
      std::stable_sort(first, last, [](const Entry& a, const Entry& b) { return a.column < b.column; });
      Entry* out = first;
      for (const Entry* in = first; in != last; ++in) {
        if (out != first && out[-1].column == in->column) {
          out[-1].weight += in->weight;
        } else {
          *out++ = *in;
        }
      }
      lower.counts[row] = static_cast<Index>(out - first);
    }
  });
  return lower;
}

}  // namespace

SparseMatrix buildLaplacian(Index rows, std::vector<WeightedEdge>&& edges) {
  const LowerRows lower = gatherLower(rows, edges);
  std::vector<WeightedEdge>().swap(edges);

  // Sizes of full rows: lower part, diagonal, and the mirrored upper part.
  std::vector<std::size_t> size(rows, 1);
  for (Index row = 0; row < rows; ++row) {
    size[row] += lower.counts[row];
    for (Index e = 0; e < lower.counts[row]; ++e) ++size[lower.entries[lower.begins[row] + e].column];
  }
  const std::size_t total = std::accumulate(size.begin(), size.end(), std::size_t{0});
  if (total > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw InvalidInput("the matrix has more than 2^31 entries");
  }
  SparseMatrix matrix(rows, rows);
  matrix.resizeNonZeros(static_cast<Eigen::Index>(total));
  int* const outer = matrix.outerIndexPtr();
  int* const inner = matrix.innerIndexPtr();
  double* const values = matrix.valuePtr();
  outer[0] = 0;
  for (Index row = 0; row < rows; ++row) outer[row + 1] = outer[row] + static_cast<int>(size[row]);

  // Rows ascending: each row's mirrored entries arrive in ascending column order behind its own lower part.
  std::vector<int> next(outer, outer + rows);
  for (Index row = 0; row < rows; ++row) {
    for (Index e = 0; e < lower.counts[row]; ++e) {
      const Entry& entry = lower.entries[lower.begins[row] + e];
      inner[next[row]] = static_cast<int>(entry.column);
      values[next[row]++] = -entry.weight;
      inner[next[entry.column]] = static_cast<int>(row);
      values[next[entry.column]++] = -entry.weight;
    }
    inner[next[row]] = static_cast<int>(row);
    values[next[row]++] = 0;
  }
  parallelFor(rows, 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      double sum = 0;
      int diagonal = outer[row];
      for (int e = outer[row]; e < outer[row + 1]; ++e) {
        sum -= values[e];
        if (inner[e] == static_cast<int>(row)) diagonal = e;
      }
      values[diagonal] = sum;
    }
  });
  return matrix;
}

void dropNegativeWeights(SparseMatrix& laplacian) {
  parallelFor(static_cast<std::size_t>(laplacian.rows()), 16384, [&](std::size_t begin, std::size_t end) {
    for (auto row = static_cast<Eigen::Index>(begin); row < static_cast<Eigen::Index>(end); ++row) {
      double sum = 0;
      double* diagonal = nullptr;
      bool drops = false;
      for (SparseMatrix::InnerIterator entry(laplacian, row); entry; ++entry) {
        if (entry.col() == row) {
          diagonal = &entry.valueRef();
          continue;
        }
        drops = drops || entry.value() > 0;
        entry.valueRef() = std::min(entry.value(), 0.0);
        sum -= entry.value();
      }
      if (drops) *diagonal = sum;
    }
  });
}

}  // namespace stipple
