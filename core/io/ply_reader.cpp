#include "core/io/ply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>

#include "core/io/faces.h"
#include "core/io/numbers.h"
#include "core/io/ply_header.h"
#include "core/io/ply_rows.h"
#include "core/io/row_assembler.h"
#include "core/parallel.h"

namespace stipple {

namespace {

constexpr std::uint64_t kMostPoints = std::numeric_limits<Index>::max() - 1;
constexpr std::size_t kRowsPerBlock = 1 << 15;
constexpr std::size_t kRowsPerReport = 1 << 21;

RowLayout layoutOf(const PlyElement& vertex, bool swapBytes) {
  std::vector<RowProperty> properties;
  for (const PlyProperty& property : vertex.properties) {
    if (!property.isList) properties.push_back({.name = property.name, .type = property.type});
  }
  RowLayout layout = packedLayout(std::move(properties));
  layout.swapBytes = swapBytes;
  return layout;
}

class PlyReader {
 public:
  PlyReader(const InputFile& file, Progress& progress)
      : file_(file), progress_(progress), header_(readPlyHeader(file)) {
    const auto vertex = std::ranges::find(header_.elements, "vertex", &PlyElement::name);
    if (vertex == header_.elements.end()) throw InvalidInput("the PLY header has no element 'vertex'");
    vertex_ = static_cast<std::size_t>(vertex - header_.elements.begin());
    if (vertex->count == 0) throw InvalidInput("holds 0 points");
    if (vertex->count > kMostPoints) {
      throw InvalidInput(
          fmt::format("promises {} points, at most {} can be held", vertex->count, kMostPoints));
    }
    pointCount_ = static_cast<Index>(vertex->count);
    planProperties(layoutOf(*vertex, false).properties);  // throws where a coordinate lacks
    rows_ = isBinary() ? openBinaryPlyRows(file, header_.dataOffset, isBigEndian())
                       : openAsciiPlyRows(file, header_.dataOffset, header_.lines);
  }

  ReadResult read() {
    for (std::size_t e = 0; e < header_.elements.size() && !ended_; ++e) {
      const PlyElement& element = header_.elements[e];
      if (e == vertex_) {
        readVertices(element);
      } else {
        readOther(element, e);
      }
    }
    ReadResult result = assembler_->finish(pointCount_, std::move(triangles_));
    for (auto* more : {&warnings_, &rowWarnings_}) {
      result.warnings.insert(result.warnings.begin(), more->begin(), more->end());
    }
    progress_.report(1, "read");
    return result;
  }

 private:
  bool isBinary() const { return header_.encoding != PlyEncoding::kAscii; }
  bool isBigEndian() const { return header_.encoding == PlyEncoding::kBigEndian; }

  [[noreturn]] void failTruncated(std::uint64_t found) const {
    throw InvalidInput(fmt::format("ends too early: {} points expected, {} found", pointCount_, found));
  }

  void readVertices(const PlyElement& vertex) {
    for (const PlyProperty& property : vertex.properties) {
      if (property.isList) {
        warnings_.push_back(fmt::format("the list '{}' of the points is dropped", property.name));
      }
    }
    if (isBinary() && !vertex.hasLists()) {
      readFixedRows(vertex);
    } else {
      readRowByRow(vertex);
    }
  }

  // Rows of equal length stand at known places: blocks of them are read and decoded in parallel.
  void readFixedRows(const PlyElement& vertex) {
    RowLayout layout = layoutOf(vertex, isBigEndian());
    const std::size_t rowBytes = layout.rowBytes;
    const std::uint64_t begin = rows_->offset();
    const std::uint64_t available =
        rowBytes > 0 && begin < file_.size() ? (file_.size() - begin) / rowBytes : 0;
    if (available < pointCount_) failTruncated(available);
    assembler_.emplace(std::move(layout), pointCount_);
    for (std::size_t part = 0; part < pointCount_; part += kRowsPerReport) {
      const std::size_t count = std::min<std::size_t>(kRowsPerReport, pointCount_ - part);
      parallelFor(
          count, kRowsPerBlock,
          [&](std::size_t first, std::size_t last) {
            const auto bytes = std::make_unique_for_overwrite<std::byte[]>((last - first) * rowBytes);
            const std::span<std::byte> block(bytes.get(), (last - first) * rowBytes);
            file_.read(begin + (part + first) * rowBytes, block);
            assembler_->decode(block, static_cast<Index>(part + first));
          },
          &progress_);
      progress_.report(static_cast<double>(part) / pointCount_, "reading");
    }
    rows_ = openBinaryPlyRows(file_, begin + std::uint64_t{pointCount_} * rowBytes, isBigEndian());
  }

  // Rows of unknown length are packed into blocks, which are then decoded like those of fixed length.
  void readRowByRow(const PlyElement& vertex) {
    const std::uint64_t rest = file_.size() - std::min(rows_->offset(), file_.size());
    const std::uint64_t mostRows = (rest + 1) / std::max<std::uint64_t>(rows_->fewestBytes(vertex), 1);
    assembler_.emplace(layoutOf(vertex, false),
                       static_cast<Index>(std::min<std::uint64_t>(pointCount_, mostRows)));
    const std::size_t rowBytes = assembler_->layout().rowBytes;
    std::vector<std::byte> block(std::min<std::size_t>(kRowsPerBlock, assembler_->capacity()) * rowBytes);
    for (Index first = 0; first < pointCount_;) {
      Index row = first;
      std::size_t filled = 0;
      while (filled < block.size() && row < pointCount_) {
        if (!rows_->read(vertex, block.data() + filled)) failTruncated(row);
        filled += rowBytes;
        ++row;
      }
      if (filled == 0) failTruncated(row);
      assembler_->decode(std::span(block).first(filled), first);
      first = row;
      reportAndCheck();
    }
    rowWarnings_ = rows_->warnings();
  }

  // Faces become triangles, everything else is skipped. What is missing before the vertices makes them
  // unreadable, what is missing after them does not.
  void readOther(const PlyElement& element, std::size_t index) {
    if (element.properties.empty()) return;
    const bool strips = element.name == "tristrips";
    std::optional<std::size_t> list;
    if (strips || element.name == "face") list = cornerList(element);
    if (element.name == "face" && !list && element.count > 0) {
      warnings_.push_back("the faces have no list of points and are ignored");
    }
    if (index > vertex_ && !list && !facesFollow(index)) return;
    std::vector<std::int64_t> corners;
    std::vector<std::byte> row(element.properties.size() * sizeof(double));
    std::uint64_t unusable = 0;
    for (std::uint64_t r = 0; r < element.count; ++r) {
      if (!readOtherRow(element, list, corners, row, index)) {
        endAfter(element, r, index);
        break;
      }
      if (r % kRowsPerBlock == 0) reportAndCheck();
      if (!list) continue;
      const bool usable = strips ? appendStrips(corners, pointCount_, triangles_)
                                 : appendPolygon(corners, pointCount_, triangles_);
      if (!usable) ++unusable;
    }
    if (unusable > 0) {
      warnings_.push_back(fmt::format("{} faces name points that do not exist and are ignored", unusable));
    }
  }

  bool readOtherRow(const PlyElement& element, std::optional<std::size_t> list,
                    std::vector<std::int64_t>& corners, std::vector<std::byte>& row, std::size_t index) {
    try {
      return list ? rows_->readList(element, *list, corners) : rows_->read(element, row.data());
    } catch (const InvalidInput&) {
      if (index < vertex_) throw;
      return false;
    }
  }

  std::optional<std::size_t> cornerList(const PlyElement& element) const {
    std::optional<std::size_t> first;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (!property.isList || isFloating(property.type)) continue;
      if (property.name == "vertex_indices" || property.name == "vertex_index") return p;
      if (!first) first = p;
    }
    return first;
  }

  bool facesFollow(std::size_t index) const {
    return std::any_of(
        header_.elements.begin() + static_cast<std::ptrdiff_t>(index) + 1, header_.elements.end(),
        [](const PlyElement& element) { return element.name == "face" || element.name == "tristrips"; });
  }

  void endAfter(const PlyElement& element, std::uint64_t found, std::size_t index) {
    if (index < vertex_) failTruncated(0);
    ended_ = true;
    warnings_.push_back(
        fmt::format("ends too early or is corrupt in element '{}': {} rows expected, {} found; the "
                    "points are complete",
                    element.name, element.count, found));
  }

  void reportAndCheck() {
    progress_.throwIfCancelled();
    progress_.report(static_cast<double>(rows_->offset()) / static_cast<double>(file_.size()), "reading");
  }

  const InputFile& file_;
  Progress& progress_;
  PlyHeader header_;
  std::size_t vertex_ = 0;
  Index pointCount_ = 0;
  std::unique_ptr<PlyRows> rows_;
  std::optional<RowAssembler> assembler_;
  std::vector<Triangle> triangles_;
  std::vector<std::string> warnings_, rowWarnings_;
  bool ended_ = false;
};

}  // namespace

ReadResult readPly(const InputFile& file, Progress& progress) {
  return PlyReader(file, progress).read();
}

}  // namespace stipple
