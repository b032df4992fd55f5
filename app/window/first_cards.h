#pragma once

#include <string>
#include <vector>

#include "app/panels/hint_cards.h"

namespace stipple {

class Registry;

/// What to try at an empty start, of what the loaded operators make possible; three at most.
std::vector<HintCard> firstCards(const Registry& registry);

/// A card that offers to bring back what a breakdown left behind.
HintCard recoveryCard(const std::string& file, std::size_t changes);
inline constexpr const char* kRecoveryCard = "recover";

}  // namespace stipple
