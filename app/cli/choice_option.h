#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace stipple {

/// Adds an option whose words stand for values; any other word is refused with the list of them.
template <class Value>
void addChoice(CLI::App& command, const std::string& name, Value& value,
               std::vector<std::pair<std::string, Value>> choices, const std::string& help) {
  std::string words;
  for (const auto& [word, meaning] : choices) words += (words.empty() ? "" : "|") + word;
  const auto choose = [&value, name, words, choices = std::move(choices)](const std::string& given) {
    for (const auto& [word, meaning] : choices) {
      if (word == given) {
        value = meaning;
        return;
      }
    }
    throw CLI::ValidationError(name, "'" + given + "' is not one of " + words);
  };
  command.add_option_function<std::string>(name, choose, help)->type_name(words);
}

}  // namespace stipple
