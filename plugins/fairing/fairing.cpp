#include "plugins/fairing/fairing.h"

#include "plugins/fairing/fairing_options.h"
#include "plugins/fairing/fairing_run.h"

namespace stipple {

namespace {

class Fairing final : public Operator {
 public:
  const OperatorDescription& description() const override { return description_; }
  std::unique_ptr<Run> start(PointSet snapshot, Region region, const Parameters& parameters) const override {
    return std::make_unique<FairingRun>(std::move(snapshot), std::move(region), parameters);
  }

 private:
  OperatorDescription description_ = {.id = "fairing",
                                      .title = "Fairing",
                                      .help =
                                          "Smooths the surface and keeps its features: anisotropic geometric "
                                          "diffusion dx/dt = div(A grad x), "
                                          "in implicit steps (M + tau L) x' = M x.",
                                      .region = RegionUse::kLimits,
                                      .parameters = fairingParameters(),
                                      .writes = {"displacement", "position", "normal"},
                                      .paintable = {{.parameter = "weight_by",
                                                     .kind = PaintKind::kWeight,
                                                     .attribute = "fairing_weight",
                                                     .title = "Weight"}}};
};

}  // namespace

std::unique_ptr<Operator> makeFairing() {
  return std::make_unique<Fairing>();
}

}  // namespace stipple
