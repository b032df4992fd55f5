#include "app/document/recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "app/document/border.h"

namespace stipple {

namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& where, std::string_view what) {
  throw InvalidInput(fmt::format("{} {}", where, what));
}

void checkKeys(const Json& object, const std::string& where, std::initializer_list<std::string_view> known) {
  if (!object.is_object()) refuse(where, "is not an object");
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) == known.end())
      refuse(where, fmt::format("has the unknown key '{}'", key));
  }
}

const Json& require(const Json& object, const std::string& where, const char* key) {
  if (!object.contains(key)) refuse(where, fmt::format("has no '{}'", key));
  return object[key];
}

std::string readText(const Json& value, const std::string& where) {
  if (!value.is_string()) refuse(where, "is not a text");
  return value.get<std::string>();
}

double readNumber(const Json& value, const std::string& where) {
  if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(where, "is not a number");
  return value.get<double>();
}

std::vector<double> readNumbers(const Json& value, const std::string& where) {
  if (!value.is_array()) return {readNumber(value, where)};
  std::vector<double> numbers;
  for (const Json& entry : value) numbers.push_back(readNumber(entry, where));
  return numbers;
}

ParameterValue readValue(const Json& value, const std::string& where) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > std::uint64_t{INT64_MAX})
    return value.get<double>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  refuse(where, "is not a bool, number or text");
}

Invocation readInvocation(const Json& step, const std::string& where, const Registry& registry) {
  checkKeys(step, where, {"operator", "parameters", "region"});
  const std::string id = readText(step["operator"], where + ": operator");
  Invocation invocation;
  try {
    invocation = makeInvocation(registry, id);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}: {}", where, error.what()));
  }
  if (step.contains("region")) invocation.region = readText(step["region"], where + ": region");
  if (!step.contains("parameters")) return invocation;
  const Json& parameters = step["parameters"];
  if (!parameters.is_object()) refuse(where + ": parameters", "is not an object");
  for (const auto& [key, value] : parameters.items()) {
    const auto& declared = invocation.parameters.declared();
    if (std::ranges::find(declared, key, &Parameter::id) == declared.end()) {
      refuse(where + ": parameters", fmt::format("has the unknown key '{}'", key));
    }
    const ParameterValue held = readValue(value, fmt::format("{}: parameter '{}'", where, key));
    try {
      invocation.parameters.set(key, held);
    } catch (const InvalidInput& error) {
      throw UsageError(fmt::format("{}: {}", where, error.what()));
    }
  }
  return invocation;
}

StrokeTool readTool(const std::string& name, const std::string& where) {
  for (const StrokeTool tool : {StrokeTool::kPaint, StrokeTool::kErase, StrokeTool::kSmooth}) {
    if (name == nameOf(tool)) return tool;
  }
  refuse(where, fmt::format("is '{}', expected paint, erase or smooth", name));
}

Stroke readStroke(const Json& step, const std::string& where) {
  checkKeys(step, where, {"stroke"});
  const Json& json = step["stroke"];
  const std::string inside = where + ": stroke";
  checkKeys(json, inside, {"tool", "attribute", "value", "radius", "strength", "dabs", "within"});
  Stroke stroke;
  stroke.tool = readTool(readText(require(json, inside, "tool"), inside + ": tool"), inside + ": tool");
  stroke.attribute = readText(require(json, inside, "attribute"), inside + ": attribute");
  if (stroke.attribute.empty()) refuse(inside + ": attribute", "is empty");
  if (stroke.tool == StrokeTool::kPaint || json.contains("value")) {
    stroke.value = readNumbers(require(json, inside, "value"), inside + ": value");
  }
  stroke.radius = readNumber(require(json, inside, "radius"), inside + ": radius");
  if (!(stroke.radius > 0)) refuse(inside + ": radius", fmt::format("is {}, expected > 0", stroke.radius));
  if (json.contains("strength")) stroke.strength = readNumber(json["strength"], inside + ": strength");
  if (!(stroke.strength > 0 && stroke.strength <= 1)) {
    refuse(inside + ": strength", fmt::format("is {}, expected in (0, 1]", stroke.strength));
  }
  if (json.contains("within")) stroke.within = readText(json["within"], inside + ": within");
  const Json& dabs = require(json, inside, "dabs");
  if (!dabs.is_array()) refuse(inside + ": dabs", "is not a list");
  for (const Json& entry : dabs) {
    const std::string place = fmt::format("{}: dabs[{}]", inside, stroke.dabs.size());
    const auto numbers = entry.is_array() ? readNumbers(entry, place) : std::vector<double>{};
    if (numbers.size() != 4 && numbers.size() != 5)
      refuse(place, "is not [x,y,z,pressure] or [x,y,z,pressure,size]");
    if (!(numbers[3] >= 0 && numbers[3] <= 1)) {
      refuse(place, fmt::format("has pressure {}, expected in [0, 1]", numbers[3]));
    }
    const double size = numbers.size() == 5 ? numbers[4] : 1;
    if (!(size > 0 && size <= 1)) refuse(place, fmt::format("has size {}, expected in (0, 1]", size));
    stroke.dabs.push_back(
        {.position = {numbers[0], numbers[1], numbers[2]}, .pressure = numbers[3], .size = size});
  }
  return stroke;
}

// A failure of the step `number`, in the same type, saying where.
template <class Call>
PointSet atStep(std::size_t number, Call&& call) {
  const auto message = [&](const std::exception& error) {
    return fmt::format("step {}: {}", number, error.what());
  };
  try {
    return call();
  } catch (const UsageError& error) {
    throw UsageError(message(error));
  } catch (const InvalidInput& error) {
    throw UsageError(message(error));
  } catch (const OperatorFailure& error) {
    throw OperatorFailure(message(error));
  }
}

Json toJson(const Invocation& invocation) {
  Json json = {{"operator", invocation.operatorId}, {"parameters", Json::object()}};
  for (const Parameter& parameter : invocation.parameters.declared()) {
    std::visit([&](const auto& held) { json["parameters"][parameter.id] = held; },
               invocation.parameters.value(parameter.id));
  }
  if (!invocation.region.empty()) json["region"] = invocation.region;
  return json;
}

Json toJson(const Stroke& stroke) {
  Json json = {{"tool", nameOf(stroke.tool)}, {"attribute", stroke.attribute}};
  if (stroke.value.size() == 1)
    json["value"] = stroke.value.front();
  else if (!stroke.value.empty())
    json["value"] = stroke.value;
  json["radius"] = stroke.radius;
  json["strength"] = stroke.strength;
  if (!stroke.within.empty()) json["within"] = stroke.within;
  json["dabs"] = Json::array();
  for (const Dab& dab : stroke.dabs) {
    json["dabs"].push_back({dab.position.x(), dab.position.y(), dab.position.z(), dab.pressure});
    if (dab.size != 1) json["dabs"].back().push_back(dab.size);
  }
  return {{"stroke", std::move(json)}};
}

}  // namespace

Recipe parseRecipe(std::string_view text, const Registry& registry) {
  Json document;
  try {
    document = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw InvalidInput(fmt::format("it is not JSON at byte {}", error.byte));
  }
  const std::string whole = "the recipe";
  checkKeys(document, whole, {"stipple_recipe", "steps"});
  if (require(document, whole, "stipple_recipe") != 1) refuse(whole, "is not of version 1");
  const Json& steps = require(document, whole, "steps");
  if (!steps.is_array()) refuse(whole + ": steps", "is not a list");
  Recipe recipe;
  for (const Json& step : steps) {
    const std::string where = fmt::format("step {}", recipe.steps.size() + 1);
    if (!step.is_object()) refuse(where, "is not an object");
    if (step.contains("stroke"))
      recipe.steps.emplace_back(readStroke(step, where));
    else if (step.contains("operator"))
      recipe.steps.emplace_back(readInvocation(step, where, registry));
    else {
      checkKeys(step, where, {});
      refuse(where, "has no 'operator' and no 'stroke'");
    }
  }
  return recipe;
}

std::string formatRecipe(const Recipe& recipe) {
  Json steps = Json::array();
  for (const Recipe::Step& step : recipe.steps) {
    steps.push_back(std::visit([](const auto& held) { return toJson(held); }, step));
  }
  return Json{{"stipple_recipe", 1}, {"steps", std::move(steps)}}.dump(2) + "\n";
}

PlayResult play(const Recipe& recipe, const Registry& registry, const PointSet& points, Progress& progress) {
  PlayResult played{.points = points, .warnings = {}};
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(recipe.steps.size(), 1));
  for (std::size_t s = 0; s < recipe.steps.size(); ++s) {
    PartialProgress part(progress, static_cast<double>(s) * share, static_cast<double>(s + 1) * share);
    played.points = atStep(s + 1, [&] {
      if (const auto* stroke = std::get_if<Stroke>(&recipe.steps[s])) {
        return applyStroke(played.points, *stroke, part);
      }
      InvocationResult done = invoke(registry, std::get<Invocation>(recipe.steps[s]), played.points, part);
      for (const std::string& warning : done.report.warnings) {
        played.warnings.push_back(fmt::format("step {}: {}", s + 1, warning));
      }
      return std::move(done.result.points);
    });
  }
  return played;
}

}  // namespace stipple
