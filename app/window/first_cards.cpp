#include "app/window/first_cards.h"

#include <fmt/format.h>

#include "plugins/api/registry.h"

namespace stipple {

namespace {

struct Offer {
  const char *id, *needs, *title, *sentence;  // needs: an operator, or nothing
};

// In the order of preference.
constexpr Offer kOffers[] = {
    {"segment", "segmentation", "Paint seeds and segment",
     "Mark two parts with different labels; the rest follows."},
    {"zebra", "texture_synthesis", "Grow a zebra", "Stripes grow over the whole surface while you watch."},
    {"repair", "inpainting", "Repair a scar",
     "Paint over a blemish; its colors are filled in from around it."},
    {"creases", "classifier", "See the creases", "Colors tell how flat the surface is around each point."},
    {"color", "", "Paint on the surface", "The brush follows the surface and never jumps to the other ear."}};
constexpr std::size_t kMostCards = 3;

}  // namespace

std::vector<HintCard> firstCards(const Registry& registry) {
  std::vector<HintCard> cards;
  for (const Offer& offer : kOffers) {
    const bool isPossible = std::string_view(offer.needs).empty() || registry.find(offer.needs);
    if (isPossible && cards.size() < kMostCards)
      cards.push_back({.id = offer.id, .title = offer.title, .sentence = offer.sentence});
  }
  return cards;
}

HintCard recoveryCard(const std::string& file, std::size_t changes) {
  return {.id = kRecoveryCard,
          .title = "Take your work back?",
          .sentence = fmt::format("{} unsaved change{} to {} outlived a breakdown.", changes,
                                  changes == 1 ? "" : "s", file)};
}

}  // namespace stipple
