#include "app/cli/command.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace stipple {

Outcome makeOutcome(bool asJson, nlohmann::ordered_json document, std::string text, std::vector<std::string> warnings) {
  if (!asJson) return {.text = std::move(text), .warnings = std::move(warnings)};
  using Json = nlohmann::ordered_json;
  document["warnings"] = std::move(warnings);
  // Numbers that are not finite become null; names that are not UTF-8 are mended.
  return {.text = document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"};
}

}  // namespace stipple
