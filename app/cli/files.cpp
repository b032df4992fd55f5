#include "app/cli/files.h"

#include <fmt/format.h>

#include "app/cli/command.h"
#include "core/io/input_file.h"
#include "core/io/output_file.h"

namespace stipple {

namespace {

template <class Call>
auto atFile(Call&& call) {
  try {
    return call();
  } catch (const InvalidInput& error) {
    throw CommandFailure(kFile, error.what());
  } catch (const IoError& error) {
    throw CommandFailure(kFile, error.what());
  }
}

}  // namespace

ReadResult readInput(const std::filesystem::path& path, Progress& progress) {
  return atFile([&] { return readPoints(path, progress); });
}

std::vector<std::string> writeOutput(const std::filesystem::path& path, const PointSet& points,
                                     const WriteOptions& options, Progress& progress) {
  return atFile([&] { return writePoints(path, points, options, progress); });
}

void checkWritable(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  // Opening a pipe or a device to try it would already be seen at its other end.
  if (std::filesystem::exists(status) && std::filesystem::is_other(status)) return;
  atFile([&] { const OutputFile attempt(path); });
}

void checkPointsWritable(const std::filesystem::path& path) {
  atFile([&] { requireWritableFormat(path); });
  checkWritable(path);
}

std::string readTextFile(const std::filesystem::path& path) {
  return atFile([&] {
    const InputFile file(path);
    return file.head(file.size());
  });
}

}  // namespace stipple
