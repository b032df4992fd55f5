#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/panel_window.h"

namespace stipple {

enum class ProcessPhase { kRunning, kPaused, kFinished };

/// A process at work, and the number that it reports after each step.
struct CurveModel {
  std::string process;              ///< "Segmentation"
  std::string quantity;             ///< of the values: "residual", "change per step"; empty: none
  std::vector<double> values = {};  ///< one a step, the latest last
  std::int64_t steps = 0;           ///< done so far
  ProcessPhase state = ProcessPhase::kRunning;
  std::optional<double> fraction = {};  ///< 0..1; none: it runs until it is stopped
  std::optional<double> secondsLeft = {};
  bool canBePaused = true;  ///< paused, stepped and stopped; all can be canceled
};

struct CurveActions {
  bool pause = false, resume = false, step = false;
  bool stop = false;    ///< keep what was reached
  bool cancel = false;  ///< back to the state before it
  bool close = false;   ///< a finished one: nothing left to see
};

CurveActions drawCurvePanel(const CurveModel& model, const PanelPlace& place);

}  // namespace stipple
