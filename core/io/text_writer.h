#pragma once

#include "core/io/format.h"

namespace stipple {

/// .xyz: x y z [red green blue] [nx ny nz], no header.
std::vector<std::string> writeXyz(OutputFile& file, const PointSet& points, const WriteOptions& options,
                                  Progress& progress);
/// .pwn: x y z nx ny nz.
std::vector<std::string> writePwn(OutputFile& file, const PointSet& points, const WriteOptions& options,
                                  Progress& progress);
/// .pts: the number of points, then x y z [intensity] [red green blue].
std::vector<std::string> writePts(OutputFile& file, const PointSet& points, const WriteOptions& options,
                                  Progress& progress);
/// .txt, .asc: a comment that names the columns, then every attribute.
std::vector<std::string> writeTable(OutputFile& file, const PointSet& points, const WriteOptions& options,
                                    Progress& progress);
/// .csv: a line that names the columns, then every attribute, separated by commas.
std::vector<std::string> writeCsv(OutputFile& file, const PointSet& points, const WriteOptions& options,
                                  Progress& progress);

}  // namespace stipple
