#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/back_end.h"
#include "app/cli/command.h"
#include "app/cli/files.h"
#include "app/cli/picture.h"
#include "app/cli/picture_files.h"
#include "app/cli/scene.h"

namespace stipple {
namespace {

namespace fs = std::filesystem;

struct TurntableOptions : RenderOptions {
  int frames = 36;
};

fs::path frameFile(const fs::path& folder, int frame) {
  return folder / fmt::format("frame_{:04}.png", frame);
}

// The folder may be missing, but not the one that it shall stand in.
void checkFolderWritable(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) {
    checkWritable(frameFile(folder, 0));
  } else if (fs::exists(folder, ignored)) {
    throw CommandFailure(kFile, fmt::format("{}: is not a folder", folder.string()));
  } else {
    checkWritable(folder.has_filename() ? folder : folder.parent_path());
  }
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (error)
    throw CommandFailure(kFile, fmt::format("{}: cannot be made ({})", folder.string(), error.message()));
}

Outcome turnAround(const TurntableOptions& options, Progress& progress) {
  checkFolderWritable(options.output);
  BackEnd backEnd(options.backend);
  StageSeconds seconds;
  const Stopwatch total;
  constexpr double kPrepared = 0.3;
  PartialProgress preparing(progress, 0, kPrepared);
  const Scene scene = readScene(options, seconds, preparing);
  PictureMaker maker(scene, options, backEnd.renderer(), seconds);
  makeFolder(options.output);
  for (int frame = 0; frame < options.frames; ++frame) {
    const auto doneBefore = [&](int f) { return kPrepared + (1 - kPrepared) * f / options.frames; };
    PartialProgress drawing(progress, doneBefore(frame), doneBefore(frame + 1));
    CameraAngles camera = options.camera;
    camera.yaw += static_cast<float>(2 * std::numbers::pi * frame / options.frames);
    const Image image = maker.take(camera, drawing);
    seconds.measure("write", [&] { writePicture(frameFile(options.output, frame), image); });
  }
  seconds.add("total", total.seconds());
  nlohmann::ordered_json json = describePictures(scene, maker, seconds);
  json["frames"] = options.frames;
  return makeOutcome(options.json, json, textOf(maker, seconds), scene.warnings);
}

}  // namespace

void addTurntable(CLI::App& program, Command& chosen) {
  const auto options = std::make_shared<TurntableOptions>();
  CLI::App* command =
      program.add_subcommand("turntable", "Draw the surface from all around into numbered PNG files");
  addRenderOptions(*command, *options);
  command->add_option("-o,--output", options->output, "Folder for frame_0000.png and so on")
      ->required()
      ->type_name("DIR");
  command->add_option("--frames", options->frames, "Pictures for one whole turn (36)")
      ->check(CLI::Range(1, 10000));
  command->callback(
      [options, &chosen] { chosen = [options](Progress& p) { return turnAround(*options, p); }; });
}

}  // namespace stipple
