#include "plugins/inpainting/inpainting.h"

#include "plugins/api/fe_parameters.h"
#include "plugins/inpainting/inpainting_run.h"

namespace stipple {

namespace {

std::vector<Parameter> inpaintingParameters() {
  // The choices stand in the order of FillMethod.
  return withFeParameters(
      {{.id = "attribute",
        .title = "Attribute",
        .type = ParameterType::kAttribute,
        .defaultValue = "color",
        .help = "What is filled in: colors (in linear light), numbers or vectors."},
       {.id = "method",
        .title = "Method",
        .type = ParameterType::kEnum,
        .defaultValue = "tensor",
        .choices = {{"tensor", "Along edges"},
                    {"harmonic", "Harmonic"},
                    {"biharmonic", "Biharmonic"},
                    {"exemplar", "Texture"}},
        .help =
            "tensor: edges of color run on, div(C A(v) grad v) = 0 with A small across them; for colors v = "
            "u / s, s the light that they take from the relief around the mask (normals, hollows), else v = "
            "u. harmonic: div(C grad u) = 0, C small at creases, as in the paper. biharmonic: lap(lap u) = "
            "0, smooth across the rim, for shadings without edges. exemplar: textures run on, each point "
            "takes the value of a known one nearby whose surroundings (37 places) look the same: least sum "
            "of squares over all patches that overlap the mask."}});
}

class Inpainting final : public Operator {
 public:
  const OperatorDescription& description() const override { return description_; }
  std::unique_ptr<Run> start(PointSet snapshot, Region region, const Parameters& parameters) const override {
    return std::make_unique<InpaintingRun>(std::move(snapshot), std::move(region), parameters);
  }

 private:
  OperatorDescription description_ = {
      .id = "inpainting",
      .title = "Inpainting",
      .help =
          "Repairs what is painted over, from what is around it: solves div(A grad u) = 0 inside the mask, "
          "or continues textures (method exemplar).",
      .region = RegionUse::kMask,
      .parameters = inpaintingParameters(),
      .writes = {"<attribute>"},
      .paintable = {{.parameter = "", .kind = PaintKind::kMask, .attribute = "mask", .title = "Mask"}},
      .runsAtEndOfStroke = true};
};

}  // namespace

std::unique_ptr<Operator> makeInpainting() {
  return std::make_unique<Inpainting>();
}

}  // namespace stipple
