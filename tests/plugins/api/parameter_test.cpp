#include "plugins/api/parameter.h"

#include <gmock/gmock.h>

#include <numbers>

#include "core/error.h"
#include "plugins/api/fe_parameters.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Parameters example() {
  return Parameters({
      {.id = "k",
       .title = "Neighbors",
       .type = ParameterType::kInt,
       .defaultValue = 30,
       .min = 3,
       .max = 200},
      {.id = "crease_angle",
       .title = "Crease",
       .unit = Unit::kAngle,
       .defaultValue = 60,
       .min = 0,
       .max = 180},
      {.id = "fill", .title = "Fill", .type = ParameterType::kBool, .defaultValue = true},
      {.id = "method",
       .title = "Method",
       .type = ParameterType::kEnum,
       .defaultValue = "heat",
       .choices = {{"heat", "Heat"}, {"sharp", "Sharp"}}},
      {.id = "seeds",
       .title = "Seeds",
       .type = ParameterType::kAttribute,
       .defaultValue = "auto",
       .choices = {{"auto", "Automatic"}}},
  });
}

TEST(Parameter, DefaultsAreThere) {
  const Parameters parameters = example();
  EXPECT_EQ(parameters.integer("k"), 30);
  EXPECT_TRUE(parameters.boolean("fill"));
  EXPECT_EQ(parameters.text("method"), "heat");
  EXPECT_EQ(parameters.text("seeds"), "auto");
}

TEST(Parameter, AnglesAreDegreesOutsideAndRadiansInside) {
  Parameters parameters = example();
  EXPECT_DOUBLE_EQ(parameters.number("crease_angle"), std::numbers::pi / 3);
  parameters.setFromAssignment("crease_angle=180");
  EXPECT_DOUBLE_EQ(parameters.number("crease_angle"), std::numbers::pi);
  EXPECT_EQ(std::get<double>(parameters.value("crease_angle")), 180);
}

TEST(Parameter, TextIsReadByTypeAndChecked) {
  Parameters parameters = example();
  parameters.setFromAssignment("k=64");
  parameters.setFromAssignment("fill=false");
  parameters.setFromAssignment("method=sharp");
  parameters.setFromAssignment("seeds=my=label");
  EXPECT_EQ(parameters.integer("k"), 64);
  EXPECT_FALSE(parameters.boolean("fill"));
  EXPECT_EQ(parameters.choiceIndex("method"), 1);
  EXPECT_EQ(parameters.text("seeds"), "my=label");
}

TEST(Parameter, ErrorsNameIdValueAndWhatWasExpected) {
  Parameters parameters = example();
  const auto setting = [&](const char* assignment) {
    return [&parameters, assignment] { parameters.setFromAssignment(assignment); };
  };
  EXPECT_THAT(setting("k=2"),
              ThrowsMessage<InvalidInput>("parameter 'k' is '2', expected an integer from 3 to 200"));
  EXPECT_THAT(setting("k=3.5"), ThrowsMessage<InvalidInput>(HasSubstr("'3.5', expected an integer")));
  EXPECT_THAT(setting("k=99999999999999999999"),
              ThrowsMessage<InvalidInput>(HasSubstr("expected an integer")));
  EXPECT_THAT(setting("k="), ThrowsMessage<InvalidInput>(HasSubstr("'k' is ''")));
  EXPECT_THAT(setting("crease_angle=nan"),
              ThrowsMessage<InvalidInput>(HasSubstr("a number from 0 to 180 (degrees)")));
  EXPECT_THAT(setting("crease_angle=1e999"), ThrowsMessage<InvalidInput>(HasSubstr("crease_angle")));
  EXPECT_THAT(setting("fill=yes"),
              ThrowsMessage<InvalidInput>("parameter 'fill' is 'yes', expected true or false"));
  EXPECT_THAT(setting("method=cold"), ThrowsMessage<InvalidInput>(HasSubstr("expected one of heat, sharp")));
  EXPECT_THAT(setting("size=1"),
              ThrowsMessage<InvalidInput>(HasSubstr("no parameter 'size', expected one of k, ")));
  EXPECT_THAT(setting("fill"), ThrowsMessage<InvalidInput>("'fill' is not of the form id=value"));
  EXPECT_EQ(parameters.integer("k"), 30) << "a refused value changes nothing";
}

TEST(Parameter, GettersRefuseOtherTypes) {
  const Parameters parameters = example();
  EXPECT_THROW(parameters.boolean("k"), InvalidInput);
  EXPECT_THROW(parameters.integer("crease_angle"), InvalidInput);
  EXPECT_THROW(parameters.text("k"), InvalidInput);
  EXPECT_THROW(parameters.number("fill"), InvalidInput);
  EXPECT_EQ(parameters.number("k"), 30.0);
}

TEST(Parameter, ContradictoryDeclarationsAreRefused) {
  const auto declaring = [](Parameter parameter) { return [parameter] { checkDeclarations({parameter}); }; };
  EXPECT_THAT(declaring({.id = "Big", .defaultValue = 1}), ThrowsMessage<InvalidInput>(HasSubstr("'Big'")));
  EXPECT_THAT(declaring({.id = "a", .defaultValue = 5, .max = 4}),
              ThrowsMessage<InvalidInput>(HasSubstr("default '5'")));
  EXPECT_THAT(declaring({.id = "a", .defaultValue = 5, .min = 7, .max = 4}),
              ThrowsMessage<InvalidInput>(HasSubstr("empty range")));
  EXPECT_THAT(declaring({.id = "a", .type = ParameterType::kInt, .defaultValue = 0.5}),
              ThrowsMessage<InvalidInput>(HasSubstr("an integer")));
  EXPECT_THAT(declaring({.id = "a", .type = ParameterType::kEnum, .defaultValue = "x"}),
              ThrowsMessage<InvalidInput>(HasSubstr("no choices")));
  EXPECT_THAT(
      [] {
        checkDeclarations({{.id = "a", .defaultValue = 1}, {.id = "a", .defaultValue = 1}});
      },
      ThrowsMessage<InvalidInput>(HasSubstr("twice")));
}

TEST(FeParameters, BecomeOptions) {
  Parameters parameters(withFeParameters({}));
  EXPECT_EQ(discretizationOptions(parameters).scheme, Scheme::kVoronoi);
  EXPECT_TRUE(discretizationOptions(parameters).consensus);
  const std::vector<std::pair<std::string, Scheme>> schemes = {{"voronoi", Scheme::kVoronoi},
                                                               {"element", Scheme::kElement},
                                                               {"paper", Scheme::kPaper},
                                                               {"mesh", Scheme::kMesh}};
  for (const auto& [id, scheme] : schemes) {
    parameters.setFromText("scheme", id);
    EXPECT_EQ(discretizationOptions(parameters).scheme, scheme) << id;
  }
  parameters.setFromText("metric", "projected");
  parameters.setFromText("consensus", "false");
  EXPECT_EQ(discretizationOptions(parameters).metric, Metric::kProjected);
  EXPECT_FALSE(discretizationOptions(parameters).consensus);
}

}  // namespace
}  // namespace stipple
