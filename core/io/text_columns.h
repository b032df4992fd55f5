#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/io/number_table.h"

namespace stipple {

/// The name that PLY has for what other programs call a column: "R" is red.
std::string canonicalColumnName(const std::string& word);

/// What the columns of a text cloud mean: by the words of its header line where they name x, y and z, else by
/// their number and values (x y z, then colors, normals and scalars).
std::vector<RowProperty> nameColumns(const NumberTable& table, const std::vector<std::string>& headerWords,
                                     std::string_view extension);

}  // namespace stipple
