#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stipple {

/// What the running process tells the window.
struct ProcessState {
  std::string operatorId, title, message;
  bool isPaused = false;
  double fraction = 0;
  std::optional<double> secondsLeft = {};
  int steps = 0;
  std::vector<double> curve = {};
};

}  // namespace stipple
