#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/pde/diffusion.h"
#include "plugins/segmentation/surface_graph.h"

namespace stipple {

/// Labels of all sites (0: none) and the diffused signal u in [0, 1] of the strongest label there.
struct Labeling {
  std::vector<std::int32_t> labels;
  std::vector<float> signal;
};

struct GrowthOptions {
  double timeStep = 0;  ///< tau, length^2
  SolverOptions solver;
};

/// Labels growing over one piece of the surface: implicit diffusion of a signal u for each label, then the
/// source K that lifts every u > theta towards 1 (Section 8.1). A site belongs for good to the label whose
/// signal first exceeds the threshold; all others are held at 0 there. Since nothing flows between pieces,
/// each is solved by itself.
class LabelGrowth {
 public:
  /// `held`: sites of the piece that keep their signal (seeds given by hand), in any order.
  LabelGrowth(const Pieces& pieces, Index piece, const SparseMatrix& stiffness, std::span<const double> mass,
              std::span<const Index> held, const GrowthOptions& options, const Progress* progress);

  /// Starts a label at sites of the piece that keep u = 1.
  void plant(std::int32_t label, std::span<const Index> sites, Labeling& labeling);
  /// Forgets the labels that grow; what they have taken stays.
  void clear();
  /// One step of all labels; returns how many sites were labelled by it.
  Index step(double threshold, Labeling& labeling, const Progress* progress);

  /// Sites taken since the last clear.
  Index taken() const { return taken_; }
  std::span<const Index> sites() const { return sites_; }

 private:
  bool react(Index rank, double threshold, Labeling& labeling);

  struct Seed {
    Index rank, column;
  };
  std::vector<Index> sites_;
  const Pieces& pieces_;
  DiffusionStepper stepper_;
  Eigen::MatrixXd u_;                 // sites of the piece x labels
  std::vector<std::int32_t> labels_;  // of the columns
  std::vector<Seed> seeds_;
  Index taken_ = 0;
};

}  // namespace stipple
