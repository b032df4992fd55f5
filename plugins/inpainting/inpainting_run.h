#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "plugins/api/operator.h"
#include "plugins/inpainting/exemplar_fill.h"

namespace stipple {

enum class FillMethod { kTensor, kHarmonic, kBiharmonic, kExemplar };

using Fill = std::variant<HarmonicFill, TensorFill, BiharmonicFill, ExemplarFill>;

/// The first step prepares the surface around the mask, too. Parameters that change start the run anew.
class InpaintingRun final : public Run {
 public:
  /// Throws InvalidInput where there is no such attribute.
  InpaintingRun(PointSet snapshot, Region region, const Parameters& parameters);

  StepState step(Progress& progress) override;
  void set(const Parameters& parameters) override;
  RunResult result() const override { return {.points = result_}; }
  Report report() const override;

 private:
  const Attribute& attribute() const;
  void prepare(Progress& progress);
  void fillUnreached(std::span<const Index> unreached, const Progress& progress);
  void write();

  PointSet snapshot_, result_;
  Region region_;
  Parameters parameters_;
  std::unique_ptr<Hole> hole_;
  std::optional<Fill> fill_;
  std::size_t pointsWithoutRim_ = 0;
  int steps_ = 0;
};

}  // namespace stipple
