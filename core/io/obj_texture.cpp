#include "core/io/obj_texture.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "core/io/numbers.h"
#include "core/io/texture.h"

namespace stipple {

namespace {

using TexturePointer = std::shared_ptr<const Texture>;

// Options such as "-s 1 1 1" stand before the file, whose name may have blanks itself: the longest end of the
// line that names a file, else the last word. Windows paths have backslashes.
std::string mapFile(std::string_view rest, const std::filesystem::path& folder) {
  std::string line(rest);
  std::ranges::replace(line, '\\', '/');
  std::string_view words = withoutBlanksAround(line), name = words;
  while (!words.empty()) {
    name = words;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(folder / name, ignored)) break;
    takeWord(words);
    words = withoutBlanksAround(words);
  }
  return std::string(name);
}

// Material name to the file of its map_Kd.
std::map<std::string, std::string> diffuseMaps(const std::filesystem::path& library) {
  std::map<std::string, std::string> maps;
  const InputFile file(library);
  LineReader lines(file);
  std::string material;
  std::string_view line;
  while (lines.next(line)) {
    const std::string_view keyword = takeWord(line);
    if (keyword == "newmtl")
      material = withoutBlanksAround(line);
    else if (keyword == "map_Kd")
      maps[material] = mapFile(line, library.parent_path());
  }
  return maps;
}

TexturePointer openTexture(const std::filesystem::path& path, std::vector<std::string>& warnings) {
  try {
    return std::make_shared<Texture>(path);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("the texture gives no colors: {}", error.what()));
    return nullptr;
  }
}

// name.png, name_texture.png, then the same with the name cut at its last underscore.
std::optional<std::filesystem::path> textureBeside(const std::filesystem::path& path) {
  std::string stem = path.stem().string();
  while (!stem.empty()) {
    for (const char* ending : {".png", "_texture.png"}) {
      const std::filesystem::path candidate = path.parent_path() / (stem + ending);
      std::error_code ignored;
      if (std::filesystem::is_regular_file(candidate, ignored)) return candidate;
    }
    const std::size_t cut = stem.rfind('_');
    stem.resize(cut == std::string::npos ? 0 : cut);
  }
  return std::nullopt;
}

// One texture a material, in the order of the materials; the last is for corners without a material.
std::vector<TexturePointer> findTextures(const std::filesystem::path& path, const ObjFile& object,
                                         std::vector<std::string>& warnings) {
  std::vector<TexturePointer> textures(object.materials.size() + 1);
  std::map<std::string, TexturePointer> opened;
  bool named = false;
  for (const std::string& library : object.libraries) {
    try {
      for (const auto& [material, file] : diffuseMaps(path.parent_path() / library)) {
        const auto found = std::ranges::find(object.materials, material);
        if (found == object.materials.end()) continue;
        named = true;
        if (!opened.contains(file)) opened[file] = openTexture(path.parent_path() / file, warnings);
        textures[static_cast<std::size_t>(found - object.materials.begin())] = opened[file];
      }
    } catch (const IoError& error) {
      warnings.push_back(fmt::format("the materials are not read: {}", error.what()));
    }
  }
  if (named) return textures;
  const auto beside = textureBeside(path);
  if (!beside) return textures;
  const TexturePointer texture = openTexture(*beside, warnings);
  if (texture) {
    warnings.push_back(
        fmt::format("names no texture; the colors are those of {} beside it", beside->filename().string()));
  }
  textures.assign(textures.size(), texture);
  return textures;
}

}  // namespace

std::vector<Rgba8> textureColors(const std::filesystem::path& path, const ObjFile& object,
                                 std::vector<std::string>& warnings) {
  const std::vector<TexturePointer> textures = findTextures(path, object, warnings);
  if (std::ranges::none_of(textures, [](const TexturePointer& texture) { return texture != nullptr; }))
    return {};
  const std::size_t count = object.vertices.rows();
  std::vector<Eigen::Vector4f> sums(count, Eigen::Vector4f::Zero());
  for (const ObjCorner& corner : object.corners) {
    const auto& texture = corner.material == ObjCorner::kNoRow ? textures.back() : textures[corner.material];
    if (!texture || corner.vertex >= count || corner.texture >= object.textureCoordinates.size()) continue;
    const Eigen::Vector2f& at = object.textureCoordinates[corner.texture];
    sums[corner.vertex] += texture->sample(at.x(), at.y()).homogeneous();
  }
  std::vector<Rgba8> colors(count, Rgba8{255, 255, 255, 255});
  for (std::size_t row = 0; row < count; ++row) {
    if (sums[row].w() == 0) continue;
    const Eigen::Array3f mean = (sums[row].head<3>() / sums[row].w()).array().round();
    colors[row] = {static_cast<std::uint8_t>(mean[0]), static_cast<std::uint8_t>(mean[1]),
                   static_cast<std::uint8_t>(mean[2]), 255};
  }
  return colors;
}

}  // namespace stipple
