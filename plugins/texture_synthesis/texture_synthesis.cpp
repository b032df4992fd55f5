#include "plugins/texture_synthesis/texture_synthesis.h"

#include "plugins/texture_synthesis/texture_options.h"
#include "plugins/texture_synthesis/texture_run.h"

namespace stipple {

namespace {

class TextureSynthesis final : public Operator {
 public:
  const OperatorDescription& description() const override { return description_; }
  std::unique_ptr<Run> start(PointSet snapshot, Region, const Parameters& parameters) const override {
    return std::make_unique<TextureRun>(std::move(snapshot), parameters);
  }

 private:
  OperatorDescription description_ = {
      .id = "texture_synthesis",
      .title = "Texture synthesis",
      .help =
          "Grows a pattern out of the surface: substances that react and diffuse, du/dt = F(u) + D div(grad "
          "u).",
      .parameters = textureParameters(),
      .writes = {"species_a", "species_b", "species_c", "species_d", "species_e", "color"},
      .paintable = {
          {.parameter = "seeds", .kind = PaintKind::kMask, .attribute = "zebra_seeds", .title = "Seeds"},
          {.parameter = "size_by", .kind = PaintKind::kWeight, .attribute = "pattern_size", .title = "Size"},
          {.parameter = "direction_by",
           .kind = PaintKind::kDirection,
           .attribute = "pattern_direction",
           .title = "Direction"}}};
};

}  // namespace

std::unique_ptr<Operator> makeTextureSynthesis() {
  return std::make_unique<TextureSynthesis>();
}

}  // namespace stipple
