#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/back_end.h"
#include "app/cli/command.h"
#include "app/cli/picture.h"
#include "app/cli/picture_files.h"
#include "app/cli/scene.h"

namespace stipple {
namespace {

Outcome renderPicture(const RenderOptions& options, Progress& progress) {
  checkPictureWritable(options.output);
  BackEnd backEnd(options.backend);
  StageSeconds seconds;
  const Stopwatch total;
  PartialProgress preparing(progress, 0, 0.7), drawing(progress, 0.7, 1);
  const Scene scene = readScene(options, seconds, preparing);
  PictureMaker maker(scene, options, backEnd.renderer(), seconds);
  const Image image = maker.take(options.camera, drawing);
  seconds.measure("write", [&] { writePicture(options.output, image); });
  seconds.add("total", total.seconds());
  return makeOutcome(options.json, describePictures(scene, maker, seconds), textOf(maker, seconds),
                     scene.warnings);
}

}  // namespace

void addRender(CLI::App& program, Command& chosen) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program.add_subcommand("render", "Draw the surface into a PNG file");
  addRenderOptions(*command, *options);
  command->add_option("-o,--output", options->output, "File to write")->required()->type_name("PNG");
  command->callback(
      [options, &chosen] { chosen = [options](Progress& p) { return renderPicture(*options, p); }; });
}

}  // namespace stipple
