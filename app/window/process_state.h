#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stipple {

/// What the running process tells the window.
struct ProcessState {
  std::string operatorId, title, message;
  bool isPaused = false;
  bool isInStep = false;  ///< also while paused, until the step that was going on ends
  double fraction = 0;
  std::optional<double> secondsLeft = {};
  int steps = 0;
  std::vector<double> curve = {};
};

}  // namespace stipple
