#pragma once

#include <optional>
#include <vector>

#include "plugins/api/operator.h"
#include "plugins/texture_synthesis/pattern_surface.h"
#include "plugins/texture_synthesis/texture_options.h"

namespace stipple {

/// One step is one time step; the first also prepares the surface. Everything that a step reads beside the
/// species follows from the parameters, so that a run goes on from written species bit for bit.
class TextureRun final : public Run {
 public:
  /// Throws InvalidInput where the pattern cannot form or would be unstable, or an attribute cannot be used.
  TextureRun(PointSet snapshot, const Parameters& parameters);

  StepState step(Progress& progress) override;
  /// Size, guides, steps, time step and colors act on the pattern at hand, and so does another pattern of the
  /// same species; anything else starts anew.
  void set(const Parameters& parameters) override;
  RunResult result() const override;
  Report report() const override;

 private:
  void prepare(Progress& progress);
  void begin(const Progress& progress);
  void readSpecies(std::vector<std::vector<float>>& species) const;
  void pack(const std::vector<std::vector<float>>& species);
  std::vector<float> speciesAt(std::size_t species) const;
  void scale();
  void planSolves();
  double advance();
  void react(std::size_t number, std::size_t begin, std::size_t end);
  int stepsWanted() const { return options_.steps > 0 ? options_.steps : system_.steps; }
  double timeStep() const { return options_.timeStep > 0 ? options_.timeStep : system_.timeStep; }
  bool goesOnWith(const Parameters& parameters) const;

  PointSet snapshot_;
  Parameters parameters_;
  TextureOptions options_;
  PatternSystem system_;

  std::optional<PatternSurface> surface_;
  bool isGuided_ = false, isScaled_ = false;
  double size_ = 0, cell_ = 0;  // wanted distance; ell, the unit of the published systems; length
  std::vector<float> beta_;     // of sites
  std::vector<DiffusingPair> pairs_;
  std::vector<PairDiffusion::Plan> plans_;  // of pairs
  std::vector<std::vector<float>> fields_;  // of pairs: the state, two species side by side
  std::vector<float> still_;                // the species that does not diffuse
  std::vector<float> right_, next_;         // fields
  int steps_ = 0;
  std::int64_t sweeps_ = 0;
};

}  // namespace stipple
