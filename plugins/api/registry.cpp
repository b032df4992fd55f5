#include "plugins/api/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace stipple {

namespace {

const std::string& idOf(const std::unique_ptr<Operator>& held) {
  return held->description().id;
}

void checkDescription(const OperatorDescription& description) {
  const auto isAllowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (description.id.empty() || !std::ranges::all_of(description.id, isAllowed)) {
    throw InvalidInput(
        fmt::format("the operator id '{}' is not lower-case letters, digits and _", description.id));
  }
  try {
    checkDeclarations(description.parameters);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("operator '{}': {}", description.id, error.what()));
  }
}

}  // namespace

void Registry::add(std::unique_ptr<Operator> added) {
  checkDescription(added->description());
  if (find(idOf(added))) throw InvalidInput(fmt::format("there already is an operator '{}'", idOf(added)));
  const auto place = std::ranges::lower_bound(operators_, idOf(added), {}, idOf);
  operators_.insert(place, std::move(added));
}

void Registry::merge(Registry&& more) {
  for (const auto& held : more.operators_) {
    if (find(idOf(held))) throw InvalidInput(fmt::format("there already is an operator '{}'", idOf(held)));
  }
  for (auto& held : more.operators_) add(std::move(held));
  more.operators_.clear();
}

const Operator* Registry::find(std::string_view id) const {
  const auto found = std::ranges::lower_bound(operators_, id, {}, idOf);
  return found != operators_.end() && idOf(*found) == id ? found->get() : nullptr;
}

}  // namespace stipple
