#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/stopwatch.h"

namespace stipple {

/// Seconds that the stages of a command took, in the order in which they came first.
class StageSeconds {
 public:
  void add(const std::string& stage, double seconds) {
    for (auto& [name, sum] : stages_) {
      if (name != stage) continue;
      sum += seconds;
      return;
    }
    stages_.emplace_back(stage, seconds);
  }
  /// Runs a piece of work and adds what it took.
  template <class Work>
  auto measure(const std::string& stage, Work&& work) {
    const Stopwatch watch;
    struct Adding {
      StageSeconds& seconds;
      const std::string& stage;
      const Stopwatch& watch;
      ~Adding() { seconds.add(stage, watch.seconds()); }
    } const adding{*this, stage, watch};
    return work();
  }
  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }

 private:
  std::vector<std::pair<std::string, double>> stages_;
};

}  // namespace stipple
