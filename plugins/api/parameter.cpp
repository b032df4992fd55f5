#include "plugins/api/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "core/error.h"

namespace stipple {

namespace {

bool isIdentifier(std::string_view id) {
  const auto isLower = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto isAllowed = [&](char c) { return isLower(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !id.empty() && isLower(id.front()) && std::ranges::all_of(id, isAllowed);
}

std::string joinChoices(const std::vector<Choice>& choices) {
  std::vector<std::string> ids;
  for (const Choice& choice : choices) ids.push_back(choice.id);
  return fmt::format("{}", fmt::join(ids, ", "));
}

std::string describeRange(const Parameter& parameter) {
  if (parameter.min && parameter.max) return fmt::format(" from {} to {}", *parameter.min, *parameter.max);
  if (parameter.min) return fmt::format(" of at least {}", *parameter.min);
  if (parameter.max) return fmt::format(" of at most {}", *parameter.max);
  return "";
}

std::string describeExpected(const Parameter& parameter) {
  const std::string unit = parameter.unit == Unit::kNone ? "" : fmt::format(" ({})", nameOf(parameter.unit));
  switch (parameter.type) {
    case ParameterType::kBool:
      return "true or false";
    case ParameterType::kInt:
      return fmt::format("an integer{}{}", describeRange(parameter), unit);
    case ParameterType::kFloat:
      return fmt::format("a number{}{}", describeRange(parameter), unit);
    case ParameterType::kEnum:
      return fmt::format("one of {}", joinChoices(parameter.choices));
    case ParameterType::kText:
      return "a text";
    case ParameterType::kAttribute:
      return parameter.choices.empty()
                 ? "the name of an attribute"
                 : fmt::format("the name of an attribute or {}", joinChoices(parameter.choices));
  }
  return "";
}

std::string describe(const ParameterValue& value) {
  return std::visit([](const auto& held) { return fmt::format("{}", held); }, value);
}

[[noreturn]] void refuse(const Parameter& parameter, std::string_view value) {
  throw InvalidInput(
      fmt::format("parameter '{}' is '{}', expected {}", parameter.id, value, describeExpected(parameter)));
}

bool isInRange(const Parameter& parameter, double value) {
  return std::isfinite(value) && (!parameter.min || value >= *parameter.min) &&
         (!parameter.max || value <= *parameter.max);
}

bool isChoice(const Parameter& parameter, const std::string& id) {
  return std::ranges::find(parameter.choices, id, &Choice::id) != parameter.choices.end();
}

// The value in the type of the parameter, or nothing where it does not fit.
std::optional<ParameterValue> fit(const Parameter& parameter, const ParameterValue& value) {
  switch (parameter.type) {
    case ParameterType::kBool:
      if (const auto* held = std::get_if<bool>(&value)) return *held;
      return {};
    case ParameterType::kInt:
      if (const auto* held = std::get_if<std::int64_t>(&value); held && isInRange(parameter, double(*held))) {
        return *held;
      }
      return {};
    case ParameterType::kFloat: {
      double number = 0;
      if (const auto* integer = std::get_if<std::int64_t>(&value))
        number = static_cast<double>(*integer);
      else if (const auto* held = std::get_if<double>(&value))
        number = *held;
      else
        return {};
      if (!isInRange(parameter, number)) return {};
      return number;
    }
    case ParameterType::kEnum:
      if (const auto* held = std::get_if<std::string>(&value); held && isChoice(parameter, *held))
        return *held;
      return {};
    case ParameterType::kText:
    case ParameterType::kAttribute:
      if (const auto* held = std::get_if<std::string>(&value)) return *held;
      return {};
  }
  return {};
}

template <class Number>
std::optional<ParameterValue> parseNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return number;
}

std::optional<ParameterValue> parse(ParameterType type, std::string_view text) {
  switch (type) {
    case ParameterType::kBool:
      if (text == "true") return true;
      if (text == "false") return false;
      return {};
    case ParameterType::kInt:
      return parseNumber<std::int64_t>(text);
    case ParameterType::kFloat:
      return parseNumber<double>(text);
    default:
      return std::string(text);
  }
}

void checkDeclaration(const Parameter& parameter) {
  const std::string where = fmt::format("the declaration of parameter '{}'", parameter.id);
  if (!isIdentifier(parameter.id)) {
    throw InvalidInput(where + " has an id that is not lower-case letters, digits and _");
  }
  if (parameter.min && parameter.max && !(*parameter.min <= *parameter.max)) {
    throw InvalidInput(fmt::format("{} has the empty range {} to {}", where, *parameter.min, *parameter.max));
  }
  if (parameter.type == ParameterType::kEnum && parameter.choices.empty()) {
    throw InvalidInput(where + " has no choices");
  }
  if (!fit(parameter, parameter.defaultValue)) {
    throw InvalidInput(fmt::format("{} has the default '{}', expected {}", where,
                                   describe(parameter.defaultValue), describeExpected(parameter)));
  }
}

}  // namespace

const char* nameOf(ParameterType type) {
  switch (type) {
    case ParameterType::kBool:
      return "bool";
    case ParameterType::kInt:
      return "int";
    case ParameterType::kFloat:
      return "float";
    case ParameterType::kEnum:
      return "enum";
    case ParameterType::kText:
      return "text";
    case ParameterType::kAttribute:
      return "attribute";
  }
  return "";
}

const char* nameOf(Unit unit) {
  switch (unit) {
    case Unit::kNone:
      return "";
    case Unit::kLength:
      return "length";
    case Unit::kAngle:
      return "degrees";
    case Unit::kArea:
      return "length^2";
    case Unit::kSpacingSquared:
      return "h^2";
    case Unit::kDiagonalSquared:
      return "D^2";
  }
  return "";
}

void checkDeclarations(const std::vector<Parameter>& declared) {
  std::set<std::string_view> ids;
  for (const Parameter& parameter : declared) {
    checkDeclaration(parameter);
    if (!ids.insert(parameter.id).second) {
      throw InvalidInput(fmt::format("parameter '{}' is declared twice", parameter.id));
    }
  }
}

Parameters::Parameters(std::vector<Parameter> declared) {
  checkDeclarations(declared);
  for (const Parameter& parameter : declared) values_.push_back(*fit(parameter, parameter.defaultValue));
  declared_ = std::make_shared<const std::vector<Parameter>>(std::move(declared));
}

std::size_t Parameters::indexOf(std::string_view id) const {
  const auto found = std::ranges::find(*declared_, id, &Parameter::id);
  if (found != declared_->end()) return static_cast<std::size_t>(found - declared_->begin());
  if (declared_->empty()) throw InvalidInput(fmt::format("there is no parameter '{}', nor any other", id));
  std::vector<std::string> ids;
  for (const Parameter& parameter : *declared_) ids.push_back(parameter.id);
  throw InvalidInput(fmt::format("there is no parameter '{}', expected one of {}", id, fmt::join(ids, ", ")));
}

const ParameterValue& Parameters::value(std::string_view id) const {
  return values_[indexOf(id)];
}

bool Parameters::boolean(std::string_view id) const {
  if (const auto* held = std::get_if<bool>(&value(id))) return *held;
  throw InvalidInput(fmt::format("parameter '{}' is not a bool", id));
}

std::int64_t Parameters::integer(std::string_view id) const {
  if (const auto* held = std::get_if<std::int64_t>(&value(id))) return *held;
  throw InvalidInput(fmt::format("parameter '{}' is not an int", id));
}

double Parameters::number(std::string_view id) const {
  const std::size_t index = indexOf(id);
  const double radiansPerUnit = (*declared_)[index].unit == Unit::kAngle ? std::numbers::pi / 180 : 1;
  if (const auto* held = std::get_if<double>(&values_[index])) return *held * radiansPerUnit;
  return static_cast<double>(integer(id)) * radiansPerUnit;
}

const std::string& Parameters::text(std::string_view id) const {
  if (const auto* held = std::get_if<std::string>(&value(id))) return *held;
  throw InvalidInput(fmt::format("parameter '{}' is not a text", id));
}

int Parameters::choiceIndex(std::string_view id) const {
  const std::vector<Choice>& choices = (*declared_)[indexOf(id)].choices;
  const auto found = std::ranges::find(choices, text(id), &Choice::id);
  if (found == choices.end()) throw InvalidInput(fmt::format("parameter '{}' is not one of its choices", id));
  return static_cast<int>(found - choices.begin());
}

void Parameters::set(std::string_view id, ParameterValue value) {
  const std::size_t index = indexOf(id);
  const Parameter& parameter = (*declared_)[index];
  auto fitting = fit(parameter, value);
  if (!fitting) refuse(parameter, describe(value));
  values_[index] = std::move(*fitting);
}

void Parameters::setFromText(std::string_view id, std::string_view text) {
  const Parameter& parameter = (*declared_)[indexOf(id)];
  const auto value = parse(parameter.type, text);
  if (!value || !fit(parameter, *value)) refuse(parameter, text);
  set(id, *value);
}

void Parameters::setFromAssignment(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    throw InvalidInput(fmt::format("'{}' is not of the form id=value", assignment));
  }
  setFromText(assignment.substr(0, equals), assignment.substr(equals + 1));
}

}  // namespace stipple
