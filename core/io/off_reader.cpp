#include "core/io/off_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/io/faces.h"
#include "core/io/number_table.h"
#include "core/io/numbers.h"

namespace stipple {

namespace {

constexpr std::uint64_t kLinesPerReport = 1 << 16;

// The letters before OFF: ST (texture coordinates), C (colors), N (normals).
struct OffKind {
  bool texture = false, colors = false, normals = false;
};

// False for keywords that are no OFF of three dimensions.
bool parseKeyword(std::string_view word, OffKind& kind) {
  if (!word.ends_with("OFF")) return false;
  word.remove_suffix(3);
  if (word.starts_with("ST")) {
    kind.texture = true;
    word.remove_prefix(2);
  }
  for (const char letter : word) {
    if (letter == 'C')
      kind.colors = true;
    else if (letter == 'N')
      kind.normals = true;
    else
      return false;
  }
  return true;
}

class OffReader {
 public:
  OffReader(const InputFile& file, Progress& progress) : progress_(progress), lines_(file) {}

  ReadResult read() {
    readHeader();
    readVertices();
    readFaces();
    ReadResult result = assembleTable(table_, properties(), std::move(triangles_));
    result.warnings.insert(result.warnings.begin(), warnings_.begin(), warnings_.end());
    return result;
  }

 private:
  // The next line that has more than a comment.
  bool nextLine(std::string_view& line) {
    while (lines_.next(line)) {
      line = line.substr(0, line.find('#'));
      while (!line.empty() && isBlank(line.front())) line.remove_prefix(1);
      if (lines_.number() % kLinesPerReport == 0) {
        progress_.throwIfCancelled();
        progress_.report(lines_.fraction(), "reading");
      }
      if (!line.empty()) return true;
    }
    return false;
  }

  void readHeader() {
    std::string_view line;
    nextLine(line);
    std::string_view counts = line;
    const std::string_view keyword = takeWord(counts);
    if (keyword.ends_with("OFF")) {
      if (!parseKeyword(keyword, kind_)) {
        throw InvalidInput(
            fmt::format("is an OFF file of the kind {}, which is not read; convert it to OFF", keyword));
      }
      std::string_view rest = counts;
      const std::string_view next = takeWord(rest);
      if (next == "BINARY") throw InvalidInput("is a binary OFF file, which is not read; convert it to PLY");
      if (next.empty()) nextLine(counts);
    } else {
      counts = line;  // some files begin with the counts
    }
    const std::string_view points = takeWord(counts), faces = takeWord(counts);
    if (!toCount(points, pointCount_) || !toCount(faces, faceCount_)) {
      throw InvalidInput(fmt::format("line {}: '{} {}' are no counts of points and faces", lines_.number(),
                                     points.substr(0, 40), faces.substr(0, 40)));
    }
    if (pointCount_ == 0) throw InvalidInput("holds 0 points");
    if (pointCount_ >= std::numeric_limits<Index>::max()) {
      throw InvalidInput(fmt::format("promises {} points, more than can be kept", pointCount_));
    }
  }

  void readVertices() {
    std::string_view line;
    for (std::uint64_t row = 0; row < pointCount_; ++row) {
      if (!nextLine(line)) {
        throw InvalidInput(fmt::format("ends too early: {} points expected, {} found", pointCount_, row));
      }
      const std::size_t before = table_.values.size();
      hasRealColors_ = hasRealColors_ || hasRealColor(line);
      if (!appendNumbers(line, table_.values)) {
        throw InvalidInput(
            fmt::format("line {}: '{}' is not a number", lines_.number(), takeWord(line).substr(0, 40)));
      }
      takeRow(before);
    }
  }

  // Colors are integers to 255, or reals to 1 where one of them is written with a point.
  bool hasRealColor(std::string_view line) const {
    const std::size_t skipped = kind_.normals ? 6 : 3;
    for (std::size_t word = 0; word < skipped; ++word) takeWord(line);
    return line.find('.') != std::string_view::npos;
  }

  void takeRow(std::size_t before) {
    const std::size_t found = table_.values.size() - before;
    const std::size_t least = kind_.normals ? 6 : 3;
    if (found < least) {
      throw InvalidInput(
          fmt::format("line {} has {} columns, expected at least {}", lines_.number(), found, least));
    }
    if (table_.columns == 0) {
      table_.columns = found;
    } else if (found != table_.columns) {
      throw InvalidInput(
          fmt::format("line {} has {} columns, expected {}", lines_.number(), found, table_.columns));
    }
  }

  // Plain OFF with three or four numbers more has colors too, whatever its keyword says.
  std::vector<RowProperty> properties() {
    std::vector<RowProperty> named = {{"x"}, {"y"}, {"z"}};
    if (kind_.normals) named.insert(named.end(), {{"nx"}, {"ny"}, {"nz"}});
    const std::size_t rest =
        table_.columns - named.size() - (kind_.texture && table_.columns >= named.size() + 2 ? 2 : 0);
    if (rest == 3 || rest == 4) {
      const bool bytes = !hasRealColors_ && table_.areBytes(named.size(), rest);
      const ScalarType type = bytes ? ScalarType::kUint8 : ScalarType::kFloat32;
      constexpr std::array<const char*, 4> kChannels = {"red", "green", "blue", "alpha"};
      for (std::size_t c = 0; c < rest; ++c) named.push_back({kChannels[c], type});
    } else if (rest > 0) {
      warnings_.push_back(
          fmt::format("{} columns of the points are not understood and kept as numbers", rest));
    }
    while (named.size() < table_.columns) {
      named.push_back({fmt::format("scalar_column_{}", named.size() + 1), realTypeOf(table_, named.size())});
    }
    return named;
  }

  void readFaces() {
    std::string_view line;
    std::vector<double> numbers;
    std::vector<std::int64_t> corners;
    std::uint64_t unusable = 0;
    for (std::uint64_t face = 0; face < faceCount_; ++face) {
      numbers.clear();
      corners.clear();
      const bool readable = nextLine(line) && appendNumbers(line, numbers) && !numbers.empty();
      if (!readable || !(numbers[0] >= 0 && numbers[0] <= static_cast<double>(numbers.size() - 1))) {
        warnings_.push_back(
            fmt::format("ends too early or is corrupt in the faces: {} expected, {} found; the points are "
                        "complete",
                        faceCount_, face));
        break;
      }
      for (std::size_t c = 1; c <= static_cast<std::size_t>(numbers[0]); ++c) {
        corners.push_back(numbers[c] >= 0 && numbers[c] < 4294967296.0 ? static_cast<std::int64_t>(numbers[c])
                                                                       : -1);
      }
      if (!appendPolygon(corners, static_cast<Index>(pointCount_), triangles_)) ++unusable;
    }
    if (unusable > 0) {
      warnings_.push_back(fmt::format("{} faces name points that do not exist and are ignored", unusable));
    }
  }

  Progress& progress_;
  LineReader lines_;
  OffKind kind_;
  std::uint64_t pointCount_ = 0, faceCount_ = 0;
  NumberTable table_;
  bool hasRealColors_ = false;
  std::vector<Triangle> triangles_;
  std::vector<std::string> warnings_;
};

}  // namespace

bool isOff(const FileSample& file) {
  std::string_view rest = file.head;
  while (!rest.empty()) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::string_view word = takeWord(line);
    if (word.empty() || word.starts_with('#')) continue;
    std::uint64_t count = 0;  // some files begin with the counts
    return (word.ends_with("OFF") && word.size() <= 8) || (file.extension == ".off" && toCount(word, count));
  }
  return false;
}

ReadResult readOff(const InputFile& file, Progress& progress) {
  return OffReader(file, progress).read();
}

}  // namespace stipple
