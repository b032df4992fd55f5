#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "plugins/api/operator.h"
#include "plugins/segmentation/barriers.h"
#include "plugins/segmentation/label_growth.h"
#include "plugins/segmentation/segmentation_options.h"

namespace stipple {

/// One step is one diffusion step of the labels that grow; the first also prepares the surface. With given
/// seeds all labels grow at once, automatic ones one after another.
class SegmentationRun final : public Run {
 public:
  /// Throws InvalidInput where the seeds cannot be used.
  SegmentationRun(PointSet snapshot, const Parameters& parameters);

  StepState step(Progress& progress) override;
  /// Steps, threshold and fill act on the labels at hand; anything else starts anew.
  void set(const Parameters& parameters) override;
  RunResult result() const override;
  Report report() const override;

 private:
  void prepare(Progress& progress);
  void plantGivenSeeds(const Progress& progress);
  bool plantNextSeed(const Progress& progress);
  std::optional<Index> findNextSeed() const;
  LabelGrowth& growthOn(Index piece, const Progress& progress);
  void spreadFromTaken();
  Index growAll(const Progress& progress);
  void finish();

  PointSet snapshot_;
  Parameters parameters_;
  SegmentationOptions options_;
  std::vector<std::int32_t> givenSeeds_;  // of file rows; empty where seeds are automatic

  std::unique_ptr<Terrain> terrain_;
  double spacing_ = 0, timeStep_ = 0;                  // h and tau, length and length^2
  std::vector<std::unique_ptr<LabelGrowth>> growths_;  // of pieces; null where nothing has grown yet
  std::vector<Index> growing_;                         // pieces
  std::vector<float> distance_;                        // of sites to what is at a crease or labelled
  std::int32_t lastLabel_ = 0;
  int steps_ = 0, stepsOfSeed_ = 0;
  bool prepared_ = false, finished_ = false;
  Labeling labeling_, complete_;  // complete: after the last whole step
};

}  // namespace stipple
