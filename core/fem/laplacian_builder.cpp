#include "core/fem/laplacian_builder.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace stipple {

namespace {

struct Entry {
  Index column;
  double weight;
};

// Items sorted by row, those of a row in their order. Blocks of items count by themselves, so that all
// threads take part; there are always as many.
class RowPlaces {
 public:
  static constexpr std::size_t kBlocks = 4;

  /// forItems(block, visit) calls visit(row) for every item of a block, in order.
  template <class ForItems>
  RowPlaces(Index rows, const ForItems& forItems) : rows_(rows), next_(kBlocks * rows), counts_(rows) {
    parallelFor(kBlocks, 1, [&](std::size_t block, std::size_t) {
      forItems(block, [&](Index row) { ++next_[block * rows_ + row]; });
    });
    parallelFor(rows, 16384, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) {
        for (std::size_t block = 0; block < kBlocks; ++block)
          counts_[row] += std::exchange(next_[block * rows_ + row], counts_[row]);
      }
    });
  }

  Index countOf(Index row) const { return counts_[row]; }
  /// Place within its row of the next item of a block.
  Index takeNext(std::size_t block, Index row) { return next_[block * rows_ + row]++; }

  /// Part of [0, count) that is this block's.
  static std::pair<std::size_t, std::size_t> rangeOf(std::size_t block, std::size_t count) {
    return {count * block / kBlocks, count * (block + 1) / kBlocks};
  }

 private:
  std::size_t rows_;
  std::vector<Index> next_, counts_;
};

// Rows of the strict lower triangle, columns ascending, equal columns added up.
struct LowerRows {
  std::vector<std::size_t> begins;
  std::vector<Index> counts;
  std::vector<Entry> entries;

  std::span<const Entry> of(std::size_t row) const { return {entries.data() + begins[row], counts[row]}; }
};

// Sorts a row and adds up equal columns; returns how many are left.
Index mergeColumns(std::span<Entry> row) {
  std::ranges::stable_sort(row, {}, &Entry::column);
  auto out = row.begin();
  for (const Entry& entry : row) {
    if (out != row.begin() && out[-1].column == entry.column) {
      out[-1].weight += entry.weight;
    } else {
      *out++ = entry;
    }
  }
  return static_cast<Index>(out - row.begin());
}

LowerRows gatherLower(Index rows, const std::vector<WeightedEdge>& edges) {
  RowPlaces places(rows, [&](std::size_t block, const auto& visit) {
    const auto [begin, end] = RowPlaces::rangeOf(block, edges.size());
    for (std::size_t e = begin; e < end; ++e) visit(std::max(edges[e].i, edges[e].j));
  });
  LowerRows lower;
  lower.begins.assign(rows + 1, 0);
  for (Index row = 0; row < rows; ++row) lower.begins[row + 1] = lower.begins[row] + places.countOf(row);
  lower.entries.resize(edges.size());
  parallelFor(RowPlaces::kBlocks, 1, [&](std::size_t block, std::size_t) {
    const auto [begin, end] = RowPlaces::rangeOf(block, edges.size());
    for (std::size_t e = begin; e < end; ++e) {
      const Index row = std::max(edges[e].i, edges[e].j);
      lower.entries[lower.begins[row] + places.takeNext(block, row)] = {std::min(edges[e].i, edges[e].j),
                                                                        edges[e].weight};
    }
  });
  lower.counts.assign(rows, 0);
  parallelFor(rows, 8192, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      lower.counts[row] = mergeColumns(
          std::span(lower.entries).subspan(lower.begins[row], places.countOf(static_cast<Index>(row))));
  });
  return lower;
}

// Minus the sums of the rows on the diagonal.
void fillDiagonal(SparseMatrix& matrix) {
  const int* const outer = matrix.outerIndexPtr();
  const int* const inner = matrix.innerIndexPtr();
  double* const values = matrix.valuePtr();
  parallelFor(static_cast<std::size_t>(matrix.rows()), 16384, [&](std::size_t begin, std::size_t end) {
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
}

}  // namespace

SparseMatrix buildLaplacian(Index rows, std::vector<WeightedEdge>&& edges) {
  const LowerRows lower = gatherLower(rows, edges);
  std::vector<WeightedEdge>().swap(edges);

  // Full rows: lower part, diagonal, and the mirrored upper part. Rows are mirrored ascending.
  RowPlaces mirrored(rows, [&](std::size_t block, const auto& visit) {
    const auto [begin, end] = RowPlaces::rangeOf(block, rows);
    for (std::size_t row = begin; row < end; ++row) {
      for (const Entry& entry : lower.of(row)) visit(entry.column);
    }
  });
  std::size_t total = rows;
  for (Index row = 0; row < rows; ++row) total += lower.counts[row] + mirrored.countOf(row);
  if (total > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw InvalidInput("the matrix has more than 2^31 entries");
  }
  SparseMatrix matrix(rows, rows);
  matrix.resizeNonZeros(static_cast<Eigen::Index>(total));
  int* const outer = matrix.outerIndexPtr();
  int* const inner = matrix.innerIndexPtr();
  double* const values = matrix.valuePtr();
  outer[0] = 0;
  for (Index row = 0; row < rows; ++row)
    outer[row + 1] = outer[row] + static_cast<int>(lower.counts[row] + mirrored.countOf(row)) + 1;

  parallelFor(RowPlaces::kBlocks, 1, [&](std::size_t block, std::size_t) {
    const auto [begin, end] = RowPlaces::rangeOf(block, rows);
    const auto put = [&](std::size_t place, std::size_t column, double value) {
      inner[place] = static_cast<int>(column);
      values[place] = value;
    };
    for (std::size_t row = begin; row < end; ++row) {
      auto place = static_cast<std::size_t>(outer[row]);
      for (const Entry& entry : lower.of(row)) {
        const Index column = entry.column;
        put(place++, column, -entry.weight);
        put(static_cast<std::size_t>(outer[column]) + lower.counts[column] + 1 +
                mirrored.takeNext(block, column),
            row, -entry.weight);
      }
      put(place, row, 0);
    }
  });
  fillDiagonal(matrix);
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
