#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/plugins/loader.h"

namespace stipple {
namespace {

using Json = nlohmann::ordered_json;

Json bound(const std::optional<double>& value, ParameterType type) {
  if (!value) return nullptr;
  if (type == ParameterType::kInt) return static_cast<std::int64_t>(*value);
  return *value;
}

Json describe(const Parameter& parameter, const ParameterValue& defaultValue) {
  Json choices = Json::array();
  for (const Choice& choice : parameter.choices) choices.push_back(choice.id);
  return {{"id", parameter.id},
          {"title", parameter.title},
          {"type", nameOf(parameter.type)},
          {"unit", nameOf(parameter.unit)},
          {"default", std::visit([](const auto& value) { return Json(value); }, defaultValue)},
          {"min", bound(parameter.min, parameter.type)},
          {"max", bound(parameter.max, parameter.type)},
          {"choices", std::move(choices)},
          {"help", parameter.help}};
}

Json describe(const OperatorDescription& description) {
  const Parameters defaults(description.parameters);
  Json parameters = Json::array();
  for (const Parameter& parameter : description.parameters) {
    parameters.push_back(describe(parameter, defaults.value(parameter.id)));
  }
  return {{"id", description.id},
          {"title", description.title},
          {"help", description.help},
          {"region", nameOf(description.region)},
          {"parameters", std::move(parameters)},
          {"writes", description.writes}};
}

std::string asText(const Json& operators) {
  std::string text;
  for (const Json& op : operators) {
    text += fmt::format("{}: {}\n", op["id"].get<std::string>(), op["help"].get<std::string>());
    for (const Json& parameter : op["parameters"]) {
      const auto unit = parameter["unit"].get<std::string>();
      text +=
          fmt::format("  {} = {}{}  {}\n", parameter["id"].get<std::string>(), parameter["default"].dump(),
                      unit.empty() ? "" : " " + unit, parameter["help"].get<std::string>());
    }
  }
  return text;
}

Outcome runOperators(bool asJson) {
  const LoadedPlugins plugins = loadPlugins(pluginFolders());
  Json operators = Json::array();
  for (const auto& held : plugins.registry.operators()) operators.push_back(describe(held->description()));
  return makeOutcome(asJson, {{"operators", operators}}, asText(operators), plugins.warnings);
}

}  // namespace

void addOperators(CLI::App& program, Command& chosen) {
  const auto json = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("operators", "List every operator with its parameters");
  command->add_flag("--json", *json, "Print one JSON document");
  command->callback([json, &chosen] { chosen = [json](Progress&) { return runOperators(*json); }; });
}

}  // namespace stipple
