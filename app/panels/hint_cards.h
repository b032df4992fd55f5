#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/panels/panel_window.h"

namespace stipple {

/// Something to try at the first start. Only what is possible is offered: the list comes from outside.
struct HintCard {
  std::string id;        ///< "segment"
  std::string title;     ///< "Paint seeds and segment"
  std::string sentence;  ///< one, of at most 90 letters
};

struct HintActions {
  std::optional<std::string> start, dismiss;  ///< ids
};

/// One place a card; cards without a place are not drawn.
HintActions drawHintCards(const std::vector<HintCard>& cards, std::span<const PanelPlace> places);

}  // namespace stipple
