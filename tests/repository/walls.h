#pragma once

#include <string>
#include <vector>

#include "tests/repository/source_tree.h"

namespace stipple {

/// What a file at `path` does wrong by naming a header; empty where it may.
std::string wallBrokenBy(const std::string& path, const Include& include);

/// Rooms that name each other in a circle, such as {"core/io", "core/points", "core/io"}; empty where there
/// is none.
std::vector<std::string> findCircle(const std::vector<SourceFile>& sources);

}  // namespace stipple
