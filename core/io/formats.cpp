#include <array>
#include <cstring>

#include "core/io/format.h"
#include "core/io/numbers.h"
#include "core/io/obj_reader.h"
#include "core/io/obj_writer.h"
#include "core/io/off_reader.h"
#include "core/io/off_writer.h"
#include "core/io/ply_reader.h"
#include "core/io/ply_writer.h"
#include "core/io/text_reader.h"
#include "core/io/text_writer.h"

namespace stipple {

namespace {

bool beginsWith(const FileSample& file, std::string_view magic) {
  return file.head.starts_with(magic);
}

bool isPly(const FileSample& file) {
  return beginsWith(file, "ply") && file.head.size() > 3 && (file.head[3] == '\n' || isBlank(file.head[3]));
}

bool isPcd(const FileSample& file) {
  return beginsWith(file, "# .PCD") || beginsWith(file, "VERSION 0.") || beginsWith(file, "VERSION .");
}

bool isCompressedLas(const FileSample& file) {
  constexpr std::size_t kPointFormat = 104;  // its highest bit says that the points are compressed
  return beginsWith(file, "LASF") && file.head.size() > kPointFormat && (file.head[kPointFormat] & 0x80) != 0;
}

bool isAsciiStl(const FileSample& file) {
  return beginsWith(file, "solid") && file.head.find("facet") != std::string::npos;
}

// 80 bytes of anything, the number of triangles, 50 bytes for each.
bool isBinaryStl(const FileSample& file) {
  constexpr std::size_t kHeader = 80;
  if (file.head.size() < kHeader + 4) return false;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, file.head.data() + kHeader, sizeof triangles);
  return file.size == kHeader + 4 + std::uint64_t{50} * triangles;
}

bool isGltf(const FileSample& file) {
  if (beginsWith(file, "glTF")) return true;
  const std::size_t first = file.head.find_first_not_of(" \t\r\n");
  return first != std::string::npos && file.head[first] == '{' &&
         (file.extension == ".gltf" || file.head.find("\"asset\"") != std::string::npos);
}

const std::vector<Format>& registry() {
  static const std::vector<Format> kFormats = {
      {.kind = "PLY", .extensions = {".ply"}, .matches = isPly, .read = readPly, .write = writePly},
      {.kind = "PCD", .extensions = {".pcd"}, .matches = isPcd, .advice = "PLY"},
      {.kind = "LAZ (compressed LAS)",
       .extensions = {".laz"},
       .matches = isCompressedLas,
       .advice = "PLY, for example with PDAL"},
      {.kind = "LAS",
       .extensions = {".las"},
       .matches = [](const FileSample& file) { return beginsWith(file, "LASF"); },
       .advice = "PLY, for example with PDAL"},
      {.kind = "E57",
       .extensions = {".e57"},
       .matches = [](const FileSample& file) { return beginsWith(file, "ASTM-E57"); },
       .advice = "PLY, for example with CloudCompare"},
      {.kind = "QSplat",
       .extensions = {".qs"},
       .matches = [](const FileSample& file) { return beginsWith(file, "QSplat"); },
       .advice = "PLY"},
      {.kind = "glTF", .extensions = {".gltf", ".glb"}, .matches = isGltf, .advice = "PLY or OBJ"},
      {.kind = "STL", .extensions = {".stl"}, .matches = isAsciiStl, .advice = "PLY or OBJ"},
      {.kind = "STL", .extensions = {".stl"}, .matches = isBinaryStl, .advice = "PLY or OBJ"},
      {.kind = "surfel", .extensions = {".pts"}, .matches = isSurfelFile, .read = readSurfels},
      {.kind = "OFF",
       .extensions = {".off"},
       .matches = isOff,
       .read = readOff,
       .write = writeOff,
       .nameSuffices = true},
      {.kind = "OBJ",
       .extensions = {".obj"},
       .matches = isObj,
       .read = readObj,
       .write = writeObj,
       .nameSuffices = true},
      {.kind = "PTX", .extensions = {".ptx"}, .matches = isPtx, .read = readPtx, .nameSuffices = true},
      {.kind = "XYZ",
       .extensions = {".xyz"},
       .matches = isTextCloud,
       .read = readText,
       .write = writeXyz,
       .nameSuffices = true},
      {.kind = "PTS",
       .extensions = {".pts"},
       .matches = isTextCloud,
       .read = readText,
       .write = writePts,
       .nameSuffices = true},
      {.kind = "PWN",
       .extensions = {".pwn"},
       .matches = isTextCloud,
       .read = readText,
       .write = writePwn,
       .nameSuffices = true},
      {.kind = "CSV",
       .extensions = {".csv"},
       .matches = isTextCloud,
       .read = readText,
       .write = writeCsv,
       .nameSuffices = true},
      {.kind = "text",
       .extensions = {".txt", ".asc"},
       .matches = isTextCloud,
       .read = readText,
       .write = writeTable,
       .nameSuffices = true},
  };
  return kFormats;
}

}  // namespace

std::span<const Format> formats() {
  return registry();
}

}  // namespace stipple
