#include "app/cli/command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace stipple {

Outcome makeOutcome(bool asJson, nlohmann::ordered_json document, std::string text,
                    std::vector<std::string> warnings) {
  if (!asJson) return {.text = std::move(text), .warnings = std::move(warnings)};
  using Json = nlohmann::ordered_json;
  document["warnings"] = std::move(warnings);
  // Numbers that are not finite become null; names that are not UTF-8 are mended.
  return {.text = document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"};
}

void addChoice(CLI::App& command, const std::string& name, std::vector<std::string> words,
               std::function<void(std::size_t)> choose, const std::string& help) {
  const std::string list = fmt::format("{}", fmt::join(words, "|"));
  const auto find = [name, list, words = std::move(words),
                     choose = std::move(choose)](const std::string& given) {
    const auto found = std::ranges::find(words, given);
    if (found == words.end())
      throw CLI::ValidationError(name, fmt::format("'{}' is not one of {}", given, list));
    choose(static_cast<std::size_t>(found - words.begin()));
  };
  command.add_option_function<std::string>(name, find, help)->type_name(list);
}

}  // namespace stipple
