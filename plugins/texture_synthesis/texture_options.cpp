#include "plugins/texture_synthesis/texture_options.h"

#include <charconv>

#include "core/error.h"
#include "plugins/api/fe_parameters.h"

namespace stipple {

namespace {

Rgba8 readColor(const Parameters& parameters, const char* id) {
  const std::string& text = parameters.text(id);
  std::uint32_t value = 0;
  const char* end = text.data() + text.size();
  const bool hasForm = text.size() == 7 && text[0] == '#';
  if (!hasForm || std::from_chars(text.data() + 1, end, value, 16).ptr != end) {
    throw InvalidInput("parameter '" + std::string(id) + "' is '" + text +
                       "', expected a color such as #c08040");
  }
  return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8 & 255),
          static_cast<std::uint8_t>(value & 255), 255};
}

std::string readName(const Parameters& parameters, const char* id, const char* none) {
  const std::string& name = parameters.text(id);
  return name == none ? std::string() : name;
}

std::vector<Parameter> patternParameters() {
  return {{.id = "pattern",
           .title = "Pattern",
           .type = ParameterType::kEnum,
           .defaultValue = "spots",
           .choices = {{"spots", "Spots"},
                       {"turk_spots", "Spots (Turk 1991, slow)"},
                       {"stripes", "Stripes"},
                       {"zebra", "Zebra"},
                       {"gray_scott", "Gray-Scott"},
                       {"gierer_meinhardt", "Gierer-Meinhardt"}},
           .help = "The substances and how they react; zebra: stripes that start at edges or painted seeds."},
          {.id = "size",
           .title = "Size",
           .unit = Unit::kLength,
           .defaultValue = 0.0,
           .min = 0,
           .help = "Distance from spot to spot or from stripe to stripe; 0: a share of the model."},
          {.id = "steps",
           .title = "Steps",
           .type = ParameterType::kInt,
           .defaultValue = std::int64_t{0},
           .min = 0,
           .max = 1000000,
           .help = "Time steps; 0: as many as the pattern usually takes."},
          {.id = "time_step",
           .title = "Time step",
           .defaultValue = 0.0,
           .min = 0,
           .max = 100,
           .help = "Time of one step; 0: that of the pattern. Too long a step is refused."},
          {.id = "seed",
           .title = "Variation",
           .type = ParameterType::kInt,
           .defaultValue = std::int64_t{1},
           .min = 0,
           .max = 1e9,
           .help = "Number of the random irregularities that a pattern starts from."},
          {.id = "resume",
           .title = "Go on",
           .type = ParameterType::kBool,
           .defaultValue = false,
           .help = "Start from species_a, species_b, ... as an earlier run left them."}};
}

std::vector<Parameter> placeParameters() {
  return {
      {.id = "size_by",
       .title = "Size by",
       .type = ParameterType::kAttribute,
       .defaultValue = "none",
       .choices = {{"none", "None"}},
       .help = "A number at each point: 0 leaves the size, 1 doubles it, -1 halves it (from -2 to 2)."},
      {.id = "direction_by",
       .title = "Direction by",
       .type = ParameterType::kAttribute,
       .defaultValue = "none",
       .choices = {{"none", "None"}},
       .help =
           "A vector at each point along which the pattern is drawn out, at length 1 to twice its width."},
      {.id = "seed_fraction",
       .title = "Seed fraction",
       .defaultValue = 0.1,
       .min = 0,
       .max = 1,
       .help = "Zebra starts where the classifier lies within this lowest part of its range."},
      {.id = "seeds",
       .title = "Seeds",
       .type = ParameterType::kAttribute,
       .defaultValue = "auto",
       .choices = {{"auto", "At edges"}},
       .help = "Zebra starts where this attribute is not 0; or at the edges of the model."},
      {.id = "color",
       .title = "Write colors",
       .type = ParameterType::kBool,
       .defaultValue = false,
       .help = "Blend two colors by the pattern into the color of the points."},
      {.id = "color_ground",
       .title = "Ground color",
       .type = ParameterType::kText,
       .defaultValue = "#f0dcb4",
       .help = "Color between spots or stripes, as #rrggbb."},
      {.id = "color_figure",
       .title = "Figure color",
       .type = ParameterType::kText,
       .defaultValue = "#3c2314",
       .help = "Color of spots or stripes, as #rrggbb."}};
}

}  // namespace

std::vector<Parameter> textureParameters() {
  std::vector<Parameter> own = patternParameters();
  for (Parameter& parameter : placeParameters()) own.push_back(std::move(parameter));
  return withFeParameters(std::move(own));
}

TextureOptions readTextureOptions(const Parameters& parameters) {
  return {.discretization = discretizationOptions(parameters),
          .pattern = parameters.choice<Pattern>("pattern"),
          .size = parameters.number("size"),
          .steps = static_cast<int>(parameters.integer("steps")),
          .timeStep = parameters.number("time_step"),
          .seed = static_cast<std::uint64_t>(parameters.integer("seed")),
          .resume = parameters.boolean("resume"),
          .sizeBy = readName(parameters, "size_by", "none"),
          .directionBy = readName(parameters, "direction_by", "none"),
          .seedFraction = parameters.number("seed_fraction"),
          .seeds = readName(parameters, "seeds", "auto"),
          .color = parameters.boolean("color"),
          .ground = readColor(parameters, "color_ground"),
          .figure = readColor(parameters, "color_figure")};
}

}  // namespace stipple
