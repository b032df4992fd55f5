#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/document/invocation.h"
#include "app/document/stroke.h"

namespace stipple {

/// What was done to a point set, to be done again to it or to another: operators and strokes in their order.
struct Recipe {
  using Step = std::variant<Invocation, Stroke>;
  std::vector<Step> steps;
};

/// Reads {"stipple_recipe":1,"steps":[...]}. Throws InvalidInput naming the place where the text is not such
/// a document or has an unknown key, UsageError where it names an unknown operator or a value out of range.
Recipe parseRecipe(std::string_view text, const Registry& registry);

/// The same document, with every parameter of every operator.
std::string formatRecipe(const Recipe& recipe);

struct PlayResult {
  PointSet points;
  std::vector<std::string> warnings;  ///< of the operators
};

/// Does all steps. Messages of failures and warnings begin with the number of the step, from 1.
PlayResult play(const Recipe& recipe, const Registry& registry, const PointSet& points, Progress& progress);

}  // namespace stipple
