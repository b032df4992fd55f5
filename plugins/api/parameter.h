#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stipple {

/// enum: the id of one of `choices`. attribute: the name of an attribute, or one of `choices` (such as
/// "auto").
enum class ParameterType { kBool, kInt, kFloat, kEnum, kText, kAttribute };
/// "bool", "int", "float", "enum", "text", "attribute".
const char* nameOf(ParameterType type);

/// length: model units. angle: degrees for users, radians in code. The last two are multiples of the squared
/// mean spacing h^2 and of the squared diagonal of the bounding box D^2.
enum class Unit { kNone, kLength, kAngle, kArea, kSpacingSquared, kDiagonalSquared };
/// "", "length", "degrees", "length^2", "h^2", "D^2".
const char* nameOf(Unit unit);

/// A value as users give it (angles in degrees). kEnum, kText and kAttribute are strings.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;

struct Choice {
  std::string id, title;
};

/// A parameter declared once as data: command line, recipe, panel and check follow from it. Ids are lower
/// case and stable. `defaultValue`, `min` and `max` are in the user's unit (degrees for angles).
struct Parameter {
  std::string id = {};
  std::string title = {};
  ParameterType type = ParameterType::kFloat;
  Unit unit = Unit::kNone;
  ParameterValue defaultValue = {};
  std::optional<double> min = {}, max = {};
  std::vector<Choice> choices = {};
  std::string help = {};
};

/// Throws InvalidInput where a declaration contradicts itself: ids, types, range, default outside the range.
void checkDeclarations(const std::vector<Parameter>& declared);

/// One value for each declared parameter, always of its type and within its range. Copies cheaply.
/// Getters and setters throw InvalidInput naming the id; setters also name the value and what was expected.
class Parameters {
 public:
  Parameters() = default;
  /// Every parameter at its default.
  explicit Parameters(std::vector<Parameter> declared);

  const std::vector<Parameter>& declared() const { return *declared_; }
  const ParameterValue& value(std::string_view id) const;

  bool boolean(std::string_view id) const;
  std::int64_t integer(std::string_view id) const;
  /// A float, or an int as double. Angles in radians.
  double number(std::string_view id) const;
  /// A text, the name of an attribute, or the id of a choice.
  const std::string& text(std::string_view id) const;
  /// The choice as an enumeration declared in the order of the choices.
  template <class Enumeration>
  Enumeration choice(std::string_view id) const {
    return static_cast<Enumeration>(choiceIndex(id));
  }
  int choiceIndex(std::string_view id) const;

  /// In the user's unit; an integer is taken for a float.
  void set(std::string_view id, ParameterValue value);
  /// As it stands on the command line: "true", "12", "0.5", "voronoi".
  void setFromText(std::string_view id, std::string_view text);
  /// "id=value".
  void setFromAssignment(std::string_view assignment);

 private:
  std::size_t indexOf(std::string_view id) const;

  std::shared_ptr<const std::vector<Parameter>> declared_ = std::make_shared<std::vector<Parameter>>();
  std::vector<ParameterValue> values_;
};

}  // namespace stipple
