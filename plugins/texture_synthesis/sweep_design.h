#pragma once

#include <span>
#include <vector>

namespace stipple {

/// A sweep towards A u = b: u'' = u' + momentum (u' - u) + gain D^-1 (b - A u'), D the diagonal.
struct Sweep {
  double momentum, gain;
};

/// Eigenvalues of D^-1 A with the weights that the change of a step has there, or would have.
struct SpectrumShare {
  double value, weight;
};

/// So many sweeps with the least sum of weight * (what they leave of the error)^2: the polynomial of
/// conjugate gradients for that spectrum (Hestenes and Stiefel 1952), fixed beforehand.
std::vector<Sweep> designSweeps(std::span<const SpectrumShare> spectrum, int count);

/// Adds `weight` in shares spread over (least value of the spectrum, largest), so that the sweeps damp there
/// too.
void addRoughShares(std::vector<SpectrumShare>& spectrum, double largest, double weight);

/// What the sweeps leave of an error at an eigenvalue: 1 at 0.
double remainderAt(std::span<const Sweep> sweeps, double eigenvalue);

/// Square root of the weighted mean square.
double remainderOf(std::span<const Sweep> sweeps, std::span<const SpectrumShare> spectrum);

/// Whether they amplify no error with eigenvalues from 0 to `largest`.
bool isDamping(std::span<const Sweep> sweeps, double largest);

}  // namespace stipple
