#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/cli/picture.h"

namespace stipple {

/// Fails with kFile, before any work, where a picture of that name could not be written.
void checkPictureWritable(const std::filesystem::path& path);

/// writePng, whose every failure ends the command with kFile.
void writePicture(const std::filesystem::path& path, const Image& image);

/// What the commands that draw say about it, in JSON and in words.
nlohmann::ordered_json describePictures(const Scene& scene, const PictureMaker& maker,
                                        const StageSeconds& seconds);
std::string textOf(const PictureMaker& maker, const StageSeconds& seconds);

}  // namespace stipple
