#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "core/fem/assembly.h"
#include "plugins/texture_synthesis/sweep_design.h"
#include "plugins/texture_synthesis/sweep_kernel.h"

namespace stipple {

/// Of (mass M + stiffness L) u = M r, one number for each of two species; stiffness in length^2.
struct PairTerms {
  std::array<double, 2> mass, stiffness;

  bool operator==(const PairTerms&) const = default;
};

/// Fields of two species are floats side by side, {a0, b0, a1, b1, ...}, with room for `paddedSites()`.
struct PairFields {
  std::span<float> right;         ///< r
  std::span<const float> before;  ///< the first guess
  std::span<float> after;
};

/// Diffusion of two species at once by a fixed polynomial in D^-1 A, D the diagonal, in float.
/// Made for short time steps, where the state before is a good first guess and a few sweeps do. Same bits for
/// any number of threads.
class PairDiffusion {
 public:
  /// How to solve with certain terms.
  struct Plan {
    PairTerms terms;
    std::array<std::vector<Sweep>, 2> sweeps;  ///< the same number for both
    std::vector<float> inverse;                ///< field: 1 / D, for masses in h^2
  };
  struct Outcome {
    int sweeps = 0;  ///< 0 where the first guess is the solution
    std::array<double, 2> squaredChange{};
  };

  /// L symmetric with zero row sums (dimensionless), M in length^2 and > 0; `spacing` is h.
  PairDiffusion(const SparseMatrix& stiffness, std::span<const double> mass, double spacing);

  std::size_t sites() const { return sites_; }
  std::size_t paddedSites() const { return mass_.size(); }

  /// Throws SolverError where mass M + stiffness L is not positive definite (scheme paper).
  Plan plan(const PairTerms& terms) const;

  /// `react(begin, end)` writes `right` at the sites [begin, end), from the state at these sites alone; what
  /// is beyond `sites()` must be 0 in all fields. Negative concentrations become 0. Throws SolverError where
  /// the values are not finite.
  Outcome solve(const Plan& plan, const PairFields& fields,
                const std::function<void(std::size_t begin, std::size_t end)>& react);

 private:
  SweepArguments argumentsOf(const PairTerms& terms) const;
  void fillDiagonal(Plan& plan) const;
  double largestEigenvalue(const Plan& plan, std::size_t lane) const;
  void requirePositive(const Plan& plan, const std::array<double, 2>& largest) const;
  std::vector<SpectrumShare> spectrumOfChange(const Plan& plan, std::size_t lane) const;
  void chooseSweeps(Plan& plan, const std::array<double, 2>& largest) const;
  void sweepAll(const SweepArguments& arguments) const;

  std::size_t sites_;
  double squaredSpacing_;
  std::vector<Index> starts_, columns_;
  std::vector<float> weights_;                      // -L off the diagonal
  std::vector<float> mass_, diagonal_, magnitude_;  // in h^2; of L; sum of |L| off the diagonal
  std::vector<float> scratch_;
};

}  // namespace stipple
