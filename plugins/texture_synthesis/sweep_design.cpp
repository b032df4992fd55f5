#include "plugins/texture_synthesis/sweep_design.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stipple {

std::vector<Sweep> designSweeps(std::span<const SpectrumShare> spectrum, int count) {
  // Conjugate gradients for a diagonal matrix; the right-hand side makes its norm the sum of the header.
  std::vector<double> residual, direction;
  for (const SpectrumShare& share : spectrum) residual.push_back(std::sqrt(share.weight * share.value));
  direction = residual;
  double energy = 0, alpha = 0, beta = 0;
  for (const double r : residual) energy += r * r;
  const double solved = 1e-20 * energy;
  std::vector<Sweep> sweeps;
  for (int sweep = 0; sweep < count; ++sweep) {
    double curvature = 0, next = 0;
    for (std::size_t i = 0; i < spectrum.size(); ++i)
      curvature += spectrum[i].value * direction[i] * direction[i];
    if (!(energy > solved)) {
      sweeps.push_back({0, 0});
      continue;
    }
    const double before = alpha;
    alpha = energy / curvature;
    sweeps.push_back({sweep == 0 ? 0 : alpha * beta / before, alpha});
    for (std::size_t i = 0; i < spectrum.size(); ++i) {
      residual[i] -= alpha * spectrum[i].value * direction[i];
      next += residual[i] * residual[i];
    }
    beta = next / energy;
    energy = next;
    for (std::size_t i = 0; i < spectrum.size(); ++i) direction[i] = residual[i] + beta * direction[i];
  }
  return sweeps;
}

void addRoughShares(std::vector<SpectrumShare>& spectrum, double largest, double weight) {
  // More than sweeps, which would fit single ones otherwise.
  constexpr int kShares = 1024;
  double least = largest;
  for (const SpectrumShare& share : spectrum) least = std::min(least, share.value);
  for (int i = 0; i < kShares; ++i) {
    const double place = 0.5 - 0.5 * std::cos(std::numbers::pi * (i + 0.5) / kShares);
    spectrum.push_back({least + (largest - least) * place, weight / kShares});
  }
}

double remainderAt(std::span<const Sweep> sweeps, double eigenvalue) {
  double before = 1, now = 1;
  for (const Sweep& sweep : sweeps) {
    const double after = now + sweep.momentum * (now - before) - sweep.gain * eigenvalue * now;
    before = now;
    now = after;
  }
  return now;
}

double remainderOf(std::span<const Sweep> sweeps, std::span<const SpectrumShare> spectrum) {
  double sum = 0, weights = 0;
  for (const SpectrumShare& share : spectrum) {
    sum += share.weight * std::pow(remainderAt(sweeps, share.value), 2);
    weights += share.weight;
  }
  return std::sqrt(sum / weights);
}

bool isDamping(std::span<const Sweep> sweeps, double largest) {
  constexpr double kRounding = 1e-9;
  // Denser towards the ends, as the waves of polynomials are: some samples for each.
  const int samples = 16 * static_cast<int>(sweeps.size() + 1);
  for (int i = 0; i <= samples; ++i) {
    const double place = 0.5 - 0.5 * std::cos(std::numbers::pi * i / samples);
    if (!(std::abs(remainderAt(sweeps, largest * place)) <= 1 + kRounding)) return false;
  }
  return true;
}

}  // namespace stipple
