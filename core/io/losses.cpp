#include "core/io/losses.h"

#include <fmt/format.h>

#include <algorithm>

namespace stipple {

const Attribute* findOfType(const PointSet& points, std::string_view name, AttributeType type) {
  const Attribute* attribute = points.find(name);
  return attribute && attribute->type() == type ? attribute : nullptr;
}

std::vector<std::string> lossesOf(const PointSet& points, const FormatMeans& means) {
  std::vector<std::string> losses;
  for (const Attribute& attribute : points.attributes()) {
    if (std::ranges::find(means.attributes, attribute.name) == means.attributes.end()) {
      losses.push_back(
          fmt::format("the attribute '{}' cannot be held by this format and is left out", attribute.name));
    }
  }
  if (!points.triangles().empty() && !means.triangles) {
    losses.push_back(fmt::format("{} triangles cannot be held by this format and are left out",
                                 points.triangles().size()));
  }
  const Attribute* color = findOfType(points, "color", AttributeType::kColor);
  if (color && !means.alpha && std::ranges::find(means.attributes, "color") != means.attributes.end() &&
      std::ranges::any_of(color->column.view<Rgba8>(), [](const Rgba8& value) { return value.a != 255; })) {
    losses.push_back("the opacity of the colors cannot be held by this format and is left out");
  }
  return losses;
}

}  // namespace stipple
