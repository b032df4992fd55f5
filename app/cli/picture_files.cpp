#include "app/cli/picture_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/files.h"
#include "render/appearance/png.h"

namespace stipple {

void checkPictureWritable(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (!ending.empty() && ending != ".png") {
    throw CommandFailure(
        kFile, fmt::format("{}: pictures are written as PNG, in a file that ends in .png", path.string()));
  }
  checkWritable(path);
}

void writePicture(const std::filesystem::path& path, const Image& image) {
  try {
    writePng(path, image);
  } catch (const IoError& error) {
    throw CommandFailure(kFile, error.what());
  }
}

nlohmann::ordered_json describePictures(const Scene& scene, const PictureMaker& maker,
                                        const StageSeconds& seconds) {
  nlohmann::ordered_json json = {{"points", scene.points.size()}, {"splats", maker.splats()}};
  if (maker.splats() == 0) json["triangles"] = scene.points.triangles().size();
  for (const auto& [stage, spent] : seconds.stages()) json["seconds"][stage] = spent;
  json["backend"] = maker.backend();
  return json;
}

std::string textOf(const PictureMaker& maker, const StageSeconds& seconds) {
  std::string text = fmt::format("{:<11} {}\n", "splats", maker.splats());
  for (const auto& [stage, spent] : seconds.stages()) text += fmt::format("{:<11} {:.3f} s\n", stage, spent);
  return text + fmt::format("{:<11} {}\n", "backend", maker.backend());
}

}  // namespace stipple
