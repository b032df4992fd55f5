#include "core/io/obj_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/io/numbers.h"
#include "core/io/obj_file.h"
#include "core/io/obj_texture.h"

namespace stipple {

namespace {

// The normal that all corners of a vertex name, or the mean direction of those that they name; zero where
// they name none.
std::vector<Eigen::Vector3f> vertexNormals(const ObjFile& object) {
  const std::size_t count = object.vertices.rows();
  std::vector<Eigen::Vector3f> normals(count, Eigen::Vector3f::Zero());
  std::vector<Index> first(count, ObjCorner::kNoRow);
  std::vector<char> differ(count, 0);
  bool found = false;
  for (const ObjCorner& corner : object.corners) {
    if (corner.vertex >= count || corner.normal >= object.normals.size()) continue;
    if (first[corner.vertex] == ObjCorner::kNoRow) first[corner.vertex] = corner.normal;
    differ[corner.vertex] |= static_cast<char>(first[corner.vertex] != corner.normal);
    normals[corner.vertex] += object.normals[corner.normal].stableNormalized();
    found = true;
  }
  if (!found) return object.normals.size() == count ? object.normals : std::vector<Eigen::Vector3f>{};
  for (std::size_t row = 0; row < count; ++row) {
    if (differ[row])
      normals[row].stableNormalize();
    else if (first[row] != ObjCorner::kNoRow)
      normals[row] = object.normals[first[row]];
  }
  return normals;
}

}  // namespace

bool isObj(const FileSample& file) {
  static constexpr std::array<std::string_view, 12> kKeywords = {
      "vn", "vt", "vp", "f", "l", "p", "g", "o", "s", "mtllib", "usemtl", "cstype"};
  std::string_view rest = file.head;
  while (!rest.empty()) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::string_view word = takeWord(line);
    double number = 0;
    if (word == "v") return toNumber(takeWord(line), number);
    const bool known =
        word.empty() || word.starts_with('#') || std::ranges::find(kKeywords, word) != kKeywords.end();
    if (!known) return false;
  }
  return false;
}

ReadResult readObj(const InputFile& file, Progress& progress) {
  ObjFile object = parseObj(file, progress);
  NumberTable& table = object.vertices;
  std::vector<RowProperty> properties = {{"x"}, {"y"}, {"z"}};
  std::vector<std::string> warnings = std::move(object.warnings);
  std::vector<Rgba8> textured;
  if (table.columns == 6) {
    for (const char* name : {"red", "green", "blue"}) properties.push_back({name, ScalarType::kFloat32});
  } else if (!object.textureCoordinates.empty()) {
    textured = textureColors(file.path(), object, warnings);
  }
  const std::vector<Eigen::Vector3f> normals = vertexNormals(object);
  // Rows that are dropped for their coordinates take these with them.
  const auto addColumns = [&](std::initializer_list<const char*> names, ScalarType type,
                              const auto& component) {
    NumberTable wider{.columns = table.columns + names.size(), .values = {}};
    wider.values.reserve(table.rows() * wider.columns);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      for (std::size_t column = 0; column < table.columns; ++column)
        wider.values.push_back(table.at(row, column));
      for (int c = 0; c < static_cast<int>(names.size()); ++c) wider.values.push_back(component(row, c));
    }
    for (const char* name : names) properties.push_back({name, type});
    table = std::move(wider);
  };
  if (!normals.empty()) {
    addColumns({"nx", "ny", "nz"}, ScalarType::kFloat32,
               [&](std::size_t row, int c) { return normals[row][c]; });
  }
  if (!textured.empty()) {
    addColumns({"red", "green", "blue"}, ScalarType::kUint8, [&](std::size_t row, int c) {
      const Rgba8& color = textured[row];
      return std::array{color.r, color.g, color.b}[static_cast<std::size_t>(c)];
    });
  }
  ReadResult result = assembleTable(table, std::move(properties), std::move(object.triangles));
  result.warnings.insert(result.warnings.begin(), warnings.begin(), warnings.end());
  return result;
}

}  // namespace stipple
