#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/fem/assembly.h"

namespace stipple {

/// Two species at one site, solved side by side so that they share each pass over the matrix. The vector type
/// of GCC and Clang: Eigen works on pairs of floats one by one.
using Pair [[gnu::vector_size(8)]] = float;

/// Of (mass M + stiffness L) u = M r, one number for each of the two species; stiffness in length^2.
struct PairTerms {
  std::array<double, 2> mass, stiffness;
};

/// Diffusion of two species at once by conjugate gradients with the diagonal as preconditioner, in float.
/// Made for short time steps, where the state before is a good first guess and a few iterations do. Sums run
/// in fixed blocks: same bits for any number of threads.
class PairDiffusion {
 public:
  /// L symmetric with zero row sums (dimensionless), M in length^2 and > 0; `spacing` is h.
  PairDiffusion(const SparseMatrix& stiffness, std::span<const double> mass, double spacing);

  /// Solves for `u`, which holds the first guess. Returns the iterations. Throws SolverError where the values
  /// are not finite, or M + tau L is not positive definite (scheme paper).
  int solve(const PairTerms& terms, std::span<const Pair> right, std::span<Pair> u);

 private:
  struct Scaled {
    Pair mass, stiffness;  // for masses in h^2
  };
  using PairSum = std::array<double, 2>;

  PairSum findResidual(const Scaled& terms, std::span<const Pair> right, std::span<const Pair> u);
  PairSum applyToDirection(const Scaled& terms);
  PairSum advance(Pair alpha, std::span<Pair> u);
  void turnDirection(Pair beta);
  Pair spread(Index row, const Pair* values) const;
  template <class Block>
  PairSum sumBlocks(const Block& block);

  std::vector<Index> offsets_, columns_;
  std::vector<float> weights_;          // -L off the diagonal
  std::vector<float> mass_, diagonal_;  // in h^2; of L
  double squaredSpacing_;
  std::vector<Pair> residual_, direction_, image_, inverse_;
  std::vector<PairSum> partial_;
};

}  // namespace stipple
