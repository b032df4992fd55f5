#pragma once

#include <filesystem>
#include <span>

#include "core/fem/point_rows.h"
#include "core/progress.h"

namespace stipple {

/// Writes the stiffness of the points as MatrixMarket `coordinate real symmetric`: the lower triangle, 17
/// significant digits, rows counted from 1. The file appears when it is complete. Throws IoError.
void writeSymmetric(const std::filesystem::path& path, const PointRows& matrix, Progress& progress);

/// Writes a diagonal matrix as MatrixMarket `coordinate real general`.
void writeDiagonal(const std::filesystem::path& path, std::span<const double> diagonal, Progress& progress);

}  // namespace stipple
