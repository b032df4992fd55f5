#include "plugins/texture_synthesis/sweep_design.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stipple {
namespace {

TEST(SweepDesign, OneSweepSolvesForOneEigenvalue) {
  const std::vector<SpectrumShare> spectrum = {{0.4, 1}};
  const std::vector<Sweep> sweeps = designSweeps(spectrum, 3);
  EXPECT_NEAR(remainderAt(sweeps, 0.4), 0, 1e-12);
  EXPECT_NEAR(sweeps[0].gain, 1 / 0.4, 1e-12);
  EXPECT_EQ(sweeps[2].gain, 0) << "nothing is left to do";
}

TEST(SweepDesign, AsManySweepsAsEigenvaluesSolve) {
  const std::vector<SpectrumShare> spectrum = {{0.1, 3}, {0.5, 1}, {1.7, 0.2}};
  EXPECT_GT(remainderOf(designSweeps(spectrum, 2), spectrum), 1e-3);
  EXPECT_LT(remainderOf(designSweeps(spectrum, 3), spectrum), 1e-12);
}

TEST(SweepDesign, LeavesTheLeastThatOneSweepCan) {
  const std::vector<SpectrumShare> spectrum = {{0.3, 1}, {0.9, 0.5}, {1.5, 0.1}};
  // Least squares of 1 - gain * value.
  double above = 0, below = 0;
  for (const SpectrumShare& share : spectrum) {
    above += share.weight * share.value;
    below += share.weight * share.value * share.value;
  }
  EXPECT_NEAR(designSweeps(spectrum, 1)[0].gain, above / below, 1e-12);
}

TEST(SweepDesign, RoughSharesKeepEveryEigenvalueFromGrowing) {
  std::vector<SpectrumShare> spectrum = {{0.2, 1}};
  EXPECT_FALSE(isDamping(designSweeps(spectrum, 1), 2)) << "1 - 5 * 2 = -9";
  addRoughShares(spectrum, 2, 0.01);
  const std::vector<Sweep> sweeps = designSweeps(spectrum, 6);
  EXPECT_TRUE(isDamping(sweeps, 2));
  for (double value = 0.1; value < 2; value += 0.01) EXPECT_LT(std::abs(remainderAt(sweeps, value)), 1);
  EXPECT_LT(std::abs(remainderAt(sweeps, 0.2)), 0.05);
}

}  // namespace
}  // namespace stipple
