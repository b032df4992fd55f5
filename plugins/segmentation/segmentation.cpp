#include "plugins/segmentation/segmentation.h"

#include "plugins/segmentation/segmentation_options.h"
#include "plugins/segmentation/segmentation_run.h"

namespace stipple {

namespace {

class Segmentation final : public Operator {
 public:
  const OperatorDescription& description() const override { return description_; }
  std::unique_ptr<Run> start(PointSet snapshot, Region, const Parameters& parameters) const override {
    return std::make_unique<SegmentationRun>(std::move(snapshot), parameters);
  }

 private:
  OperatorDescription description_ = {
      .id = "segmentation",
      .title = "Segmentation",
      .help = "Labels spread from seeds over the surface by diffusion and stop at creases.",
      .parameters = segmentationParameters(),
      .writes = {"segment", "segment_signal"},
      .paintable = {
          {.parameter = "seeds", .kind = PaintKind::kLabels, .attribute = "seeds", .title = "Seeds"}}};
};

}  // namespace

std::unique_ptr<Operator> makeSegmentation() {
  return std::make_unique<Segmentation>();
}

}  // namespace stipple
