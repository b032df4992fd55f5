#include "app/view/rate_control.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace stipple {
namespace {

// A machine and a model: nodes go with 1 / tau^2, each costs the same, and a picture costs something by
// itself.
struct Machine {
  double nodesAtOne, costOfNode, costOfPicture, noise;

  double draw(RateControl& rate, float tau, std::mt19937& random) const {
    const double nodes = nodesAtOne / (double(tau) * tau);
    std::uniform_real_distribution<double> factor(1 - noise, 1 + noise);
    const double milliseconds = (costOfPicture + costOfNode * nodes) * factor(random);
    rate.drew(static_cast<Index>(nodes), tau, milliseconds);
    return milliseconds;
  }
};

std::vector<float> run(const Machine& machine, double budget, int frames,
                       std::vector<double>* times = nullptr) {
  RateControl rate;
  std::mt19937 random(1);
  std::vector<float> taus;
  for (int frame = 0; frame < frames; ++frame) {
    taus.push_back(rate.tauFor(budget));
    const double time = machine.draw(rate, taus.back(), random);
    if (times) times->push_back(time);
  }
  return taus;
}

TEST(RateControl, FindsTheBudgetWithinAFewFrames) {
  const Machine machine{.nodesAtOne = 2e7, .costOfNode = 7e-5, .costOfPicture = 12, .noise = 0};
  std::vector<double> times;
  run(machine, 33, 40, &times);
  for (std::size_t frame = 10; frame < times.size(); ++frame) {
    EXPECT_GT(times[frame], 33 * 0.7) << frame;
    EXPECT_LT(times[frame], 33 * 1.3) << frame;
  }
}

TEST(RateControl, RestsWhereTheNoiseOfTimesIsATenth) {
  const Machine machine{.nodesAtOne = 2e7, .costOfNode = 7e-5, .costOfPicture = 12, .noise = 0.1};
  const std::vector<float> taus = run(machine, 33, 100);
  int changes = 0;
  for (std::size_t frame = 41; frame < taus.size(); ++frame) changes += taus[frame] != taus[frame - 1];
  EXPECT_LE(changes, 12);
}

TEST(RateControl, SmallModelsAreDrawnAtTheFinest) {
  const Machine machine{.nodesAtOne = 1e5, .costOfNode = 7e-5, .costOfPicture = 5, .noise = 0.1};
  EXPECT_EQ(run(machine, 33, 20).back(), RateControl::kFinest);
}

TEST(RateControl, NeverGivesUpShowingSomething) {
  const Machine machine{.nodesAtOne = 5e8, .costOfNode = 1e-3, .costOfPicture = 100, .noise = 0.3};
  const std::vector<float> taus = run(machine, 33, 60);
  EXPECT_LE(taus.back(), RateControl::kCoarsest);
  EXPECT_GE(taus.back(), 0.5f * RateControl::kCoarsest);
}

}  // namespace
}  // namespace stipple
