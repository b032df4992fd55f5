#include <fmt/format.h>

#include <limits>

#include "core/io/numbers.h"
#include "core/io/row_assembler.h"
#include "core/io/text_reader.h"

namespace stipple {

namespace {

struct SurfelHeader {
  RowLayout layout;
  std::uint64_t points = 0;
  std::uint64_t dataOffset = 0;
};

void addProperties(SurfelHeader& header, std::initializer_list<const char*> names, ScalarType type) {
  std::size_t offset = header.layout.rowBytes;
  for (const char* name : names) {
    header.layout.properties.push_back({name, type, offset});
    offset += sizeOf(type);
  }
}

// Lines "property NAME BYTES" in the order of the record; what is not known is skipped by its length.
void takeProperty(SurfelHeader& header, std::string_view name, std::uint64_t bytes) {
  if (name == "position" && bytes == 12) addProperties(header, {"x", "y", "z"}, ScalarType::kFloat32);
  if (name == "radius" && bytes == 4) addProperties(header, {"radius"}, ScalarType::kFloat32);
  if (name == "normal" && bytes == 12) addProperties(header, {"nx", "ny", "nz"}, ScalarType::kFloat32);
  // The fourth byte of a color is no opacity.
  if (name == "color" && bytes == 4) addProperties(header, {"red", "green", "blue"}, ScalarType::kUint8);
  header.layout.rowBytes += bytes;
}

SurfelHeader readHeader(const InputFile& file) {
  constexpr std::uint64_t kLargestProperty = 1 << 16;
  SurfelHeader header;
  LineReader lines(file);
  std::string_view line;
  lines.next(line);
  while (lines.next(line)) {
    const std::string_view keyword = takeWord(line);
    if (keyword == "data") {
      header.dataOffset = lines.offset();
      return header;
    }
    const std::string_view name = keyword == "property" ? takeWord(line) : std::string_view{};
    std::uint64_t number = 0;
    if ((keyword != "property" && keyword != "nofpoints") || !toCount(takeWord(line), number) ||
        (keyword == "property" && number > kLargestProperty)) {
      throw InvalidInput(fmt::format("line {} of the surfel header cannot be understood", lines.number()));
    }
    if (keyword == "property")
      takeProperty(header, name, number);
    else
      header.points = number;
  }
  throw InvalidInput("the surfel header ends without 'data'");
}

}  // namespace

bool isSurfelFile(const FileSample& file) {
  return file.head.starts_with("[Expe/PointSet/Binary");
}

ReadResult readSurfels(const InputFile& file, Progress& progress) {
  SurfelHeader header = readHeader(file);
  const std::size_t rowBytes = header.layout.rowBytes;
  if (header.points == 0) throw InvalidInput("holds 0 points");
  const std::uint64_t found = rowBytes ? (file.size() - header.dataOffset) / rowBytes : 0;
  if (found < header.points) {
    throw InvalidInput(fmt::format("ends too early: {} points expected, {} found", header.points, found));
  }
  if (header.points >= std::numeric_limits<Index>::max()) {
    throw InvalidInput(fmt::format("promises {} points, more than can be kept", header.points));
  }
  const auto count = static_cast<Index>(header.points);
  RowAssembler assembler(std::move(header.layout), count);
  constexpr Index kBlock = 1 << 15;
  std::vector<std::byte> block;
  for (Index first = 0; first < count; first += std::min(kBlock, count - first)) {
    block.resize(std::min(kBlock, count - first) * rowBytes);
    file.read(header.dataOffset + std::uint64_t{first} * rowBytes, block);
    assembler.decode(block, first);
    progress.throwIfCancelled();
    progress.report(static_cast<double>(first) / count, "reading");
  }
  return assembler.finish(count);
}

}  // namespace stipple
