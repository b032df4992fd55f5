#include "core/io/point_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <new>

#include "core/io/format.h"
#include "core/io/input_file.h"
#include "core/io/output_file.h"

namespace stipple {

namespace {

std::string extensionOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

bool hasExtension(const Format& format, std::string_view extension) {
  return std::ranges::find(format.extensions, extension) != format.extensions.end();
}

// Content decides; among the formats that the content allows, the one of the name. Text that looks like none
// of them is read as what its name says, so that the error can name the line.
const Format* recognize(const FileSample& sample) {
  const Format* first = nullptr;
  for (const Format& format : formats()) {
    if (!format.matches(sample)) continue;
    if (hasExtension(format, sample.extension)) return &format;
    if (!first) first = &format;
  }
  if (first || sample.head.find('\0') != std::string::npos) return first;
  const auto named = std::ranges::find_if(formats(), [&](const Format& format) {
    return format.nameSuffices && hasExtension(format, sample.extension);
  });
  return named == formats().end() ? nullptr : &*named;
}

std::string kindsRead() {
  std::string list;
  for (const Format& format : formats()) {
    if (format.read) list += (list.empty() ? "" : ", ") + std::string(format.kind);
  }
  return list;
}

std::string extensionsWritten() {
  std::string list;
  for (const Format& format : formats()) {
    if (!format.write) continue;
    for (const std::string_view extension : format.extensions)
      list += (list.empty() ? "" : ", ") + std::string(extension);
  }
  return list;
}

// With the mark and the ends of lines that readers of text are spared too.
FileSample sampleOf(const InputFile& file) {
  FileSample sample{file.head(InputFile::kHeadBytes), extensionOf(file.path()), file.size()};
  const TextLayout layout = layoutOf(sample.head);
  if (layout.newline == '\r') std::ranges::replace(sample.head, '\r', '\n');
  sample.head.erase(0, layout.begin);
  return sample;
}

ReadResult readRecognized(const InputFile& file, Progress& progress) {
  if (file.size() == 0) throw InvalidInput("is empty");
  const FileSample sample = sampleOf(file);
  const Format* format = recognize(sample);
  if (!format) throw InvalidInput(fmt::format("is of no kind that is known; what is read: {}", kindsRead()));
  if (!format->read) {
    throw InvalidInput(
        fmt::format("is a {} file, which is not read yet; convert it to {}", format->kind, format->advice));
  }
  return format->read(file, progress);
}

// The format that the name asks for.
const Format& findWritable(const std::filesystem::path& path) {
  const std::string extension = extensionOf(path);
  const Format* known = nullptr;
  for (const Format& format : formats()) {
    if (!hasExtension(format, extension)) continue;
    if (!known || format.write) known = &format;
  }
  if (!known || !known->write) {
    throw InvalidInput(fmt::format("{}: {} is not written; the names of what is written end in {}",
                                   path.string(), known ? known->kind : "a file of this name",
                                   extensionsWritten()));
  }
  return *known;
}

}  // namespace

ReadResult readPoints(const std::filesystem::path& path, Progress& progress) {
  const InputFile file(path);
  return readPoints(file, progress);
}

ReadResult readPoints(const InputFile& file, Progress& progress) {
  try {
    return readRecognized(file, progress);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", file.path().string(), error.what()));
  } catch (const std::bad_alloc&) {
    throw IoError(fmt::format("{}: there is not enough memory to read it", file.path().string()));
  }
}

void requireWritableFormat(const std::filesystem::path& path) {
  findWritable(path);
}

std::vector<std::string> writePoints(const std::filesystem::path& path, const PointSet& points,
                                     const WriteOptions& options, Progress& progress) {
  const Format& format = findWritable(path);
  OutputFile file(path);
  std::vector<std::string> warnings = format.write(file, points, options, progress);
  file.commit();
  return warnings;
}

}  // namespace stipple
