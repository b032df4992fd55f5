#pragma once

#include <filesystem>
#include <span>

#include "core/fem/assembly.h"

namespace stipple {

/// Writes a symmetric matrix as MatrixMarket `coordinate real symmetric`: the lower triangle, 17 significant
/// digits, rows counted from 1. The file appears when it is complete. Throws IoError.
void writeSymmetric(const std::filesystem::path& path, const SparseMatrix& matrix, Progress& progress);

/// Writes a diagonal matrix as MatrixMarket `coordinate real general`.
void writeDiagonal(const std::filesystem::path& path, std::span<const double> diagonal, Progress& progress);

}  // namespace stipple
