#include "core/io/obj_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/io/faces.h"
#include "core/io/numbers.h"

namespace stipple {

namespace {

constexpr std::uint64_t kLinesPerReport = 1 << 16;

class ObjParser {
 public:
  ObjParser(const InputFile& file, Progress& progress) : progress_(progress), lines_(file) {}

  ObjFile parse() {
    std::string_view line;
    while (nextStatement(line)) takeStatement(line);
    if (object_.vertices.rows() == 0) throw InvalidInput("holds 0 points");
    if (unusableFaces_ > 0) {
      object_.warnings.push_back(
          fmt::format("{} faces cannot be understood and are ignored", unusableFaces_));
    }
    return std::move(object_);
  }

 private:
  // A backslash at the end goes on with the next line.
  bool nextStatement(std::string_view& line) {
    if (!lines_.next(line)) return false;
    if (lines_.number() % kLinesPerReport == 0) {
      progress_.throwIfCancelled();
      progress_.report(lines_.fraction(), "reading");
    }
    if (!line.ends_with('\\')) return true;
    joined_.clear();
    bool more = true;
    while (more && line.ends_with('\\')) {
      joined_.append(line.substr(0, line.size() - 1)).append(" ");
      more = lines_.next(line);
    }
    if (more) joined_.append(line);
    line = joined_;
    return true;
  }

  void takeStatement(std::string_view line) {
    const std::string_view keyword = takeWord(line);
    if (keyword == "v")
      takeVertex(line);
    else if (keyword == "f")
      takeFace(line);
    else if (keyword == "vn")
      takeVector(line, object_.normals);
    else if (keyword == "vt")
      takeVector(line, object_.textureCoordinates);
    else if (keyword == "usemtl")  // names may have blanks: everything to the end of the line
      takeMaterial(std::string(withoutBlanksAround(line)));
    else if (keyword == "mtllib")
      object_.libraries.emplace_back(withoutBlanksAround(line));
  }

  // Numbers of one statement; a comment may follow them.
  const std::vector<double>& numbersOf(std::string_view line, std::size_t least) {
    numbers_.clear();
    line = line.substr(0, line.find('#'));
    if (!appendNumbers(line, numbers_)) {
      throw InvalidInput(
          fmt::format("line {}: '{}' is not a number", lines_.number(), takeWord(line).substr(0, 40)));
    }
    if (numbers_.size() < least) {
      throw InvalidInput(
          fmt::format("line {} has {} numbers, expected {}", lines_.number(), numbers_.size(), least));
    }
    return numbers_;
  }

  // x y z, a weight that is ignored, or x y z and a color. Once a color came, points without one are white.
  void takeVertex(std::string_view line) {
    const std::vector<double>& numbers = numbersOf(line, 3);
    NumberTable& vertices = object_.vertices;
    const bool colored = numbers.size() >= 6;
    if (vertices.columns == 0) vertices.columns = colored ? 6 : 3;
    if (colored && vertices.columns == 3) widen();
    vertices.values.insert(vertices.values.end(), numbers.begin(), numbers.begin() + 3);
    for (std::size_t channel = 3; channel < vertices.columns; ++channel) {
      vertices.values.push_back(colored ? numbers[channel] : 1);
    }
  }

  void widen() {
    NumberTable wide{.columns = 6, .values = {}};
    for (std::size_t row = 0; row < object_.vertices.rows(); ++row) {
      for (std::size_t c = 0; c < 6; ++c) wide.values.push_back(c < 3 ? object_.vertices.at(row, c) : 1);
    }
    object_.vertices = std::move(wide);
  }

  template <class Vector>
  void takeVector(std::string_view line, std::vector<Vector>& list) {
    const std::vector<double>& numbers = numbersOf(line, 1);
    Vector vector = Vector::Zero();
    for (std::size_t c = 0; c < std::min<std::size_t>(numbers.size(), Vector::SizeAtCompileTime); ++c) {
      vector[static_cast<Eigen::Index>(c)] = static_cast<float>(numbers[c]);
    }
    list.push_back(vector);
  }

  void takeMaterial(std::string name) {
    const auto found = std::ranges::find(object_.materials, name);
    material_ = static_cast<Index>(found - object_.materials.begin());
    if (found == object_.materials.end()) object_.materials.push_back(std::move(name));
  }

  void takeFace(std::string_view line) {
    polygon_.clear();
    const std::size_t cornersBefore = object_.corners.size();
    for (std::string_view word = takeWord(line); !word.empty() && word.front() != '#';
         word = takeWord(line)) {
      ObjCorner corner{.material = material_};
      if (!parseCorner(word, corner)) {
        object_.corners.resize(cornersBefore);
        ++unusableFaces_;
        return;
      }
      polygon_.push_back(corner.vertex);
      if (corner.texture != ObjCorner::kNoRow || corner.normal != ObjCorner::kNoRow)
        object_.corners.push_back(corner);
    }
    appendPolygon(polygon_, ObjCorner::kNoRow, object_.triangles);
  }

  // v, v/vt, v//vn or v/vt/vn; from 1, or below 0 from the last one back.
  bool parseCorner(std::string_view word, ObjCorner& corner) const {
    const std::size_t counts[] = {object_.vertices.rows(), object_.textureCoordinates.size(),
                                  object_.normals.size()};
    Index* const targets[] = {&corner.vertex, &corner.texture, &corner.normal};
    for (std::size_t part = 0; part < 3; ++part) {
      const std::size_t slash = word.find('/');
      const std::string_view digits = word.substr(0, slash);
      if (!digits.empty() && !parseIndex(digits, counts[part], *targets[part])) return false;
      if (slash == std::string_view::npos) break;
      word.remove_prefix(slash + 1);
    }
    return corner.vertex != ObjCorner::kNoRow;
  }

  static bool parseIndex(std::string_view digits, std::size_t count, Index& index) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size() || value == 0) return false;
    const std::int64_t row = value > 0 ? value - 1 : static_cast<std::int64_t>(count) + value;
    if (row < 0 || row >= ObjCorner::kNoRow) return false;
    index = static_cast<Index>(row);
    return true;
  }

  Progress& progress_;
  LineReader lines_;
  ObjFile object_;
  std::string joined_;
  std::vector<double> numbers_;
  std::vector<std::int64_t> polygon_;
  Index material_ = ObjCorner::kNoRow;
  std::uint64_t unusableFaces_ = 0;
};

}  // namespace

ObjFile parseObj(const InputFile& file, Progress& progress) {
  return ObjParser(file, progress).parse();
}

}  // namespace stipple
