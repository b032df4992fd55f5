#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/panels/panel_window.h"

namespace stipple {

struct StatisticsModel {
  std::vector<float> frameMilliseconds = {};  ///< the latest last
  std::int64_t points = 0, splats = 0;
  float tau = 0;  ///< pixels
  std::string backEnd;
};

void drawStatisticsPanel(const StatisticsModel& model, const PanelPlace& place);

}  // namespace stipple
