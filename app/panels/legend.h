#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/panels/panel_window.h"
#include "render/appearance/colormap.h"

namespace stipple {

/// Numbers from `low` to `high` as colors.
struct ScalarLegend {
  Colormap colormap = Colormap::kViridis;
  double low = 0, high = 1;
  std::string unit = {};
};

struct LabelCount {
  std::int64_t label = 0;
  std::int64_t points = 0;
};
struct LabelLegend {
  std::vector<LabelCount> labels = {};
};

struct LegendModel {
  std::string attribute;
  std::variant<ScalarLegend, LabelLegend> content;
};

struct LegendActions {
  std::optional<std::int64_t> label;  ///< clicked: to be shown, selected or painted
};

LegendActions drawLegend(const LegendModel& model, const PanelPlace& place);

}  // namespace stipple
