#include "core/io/off_writer.h"

#include <fmt/format.h>

#include "core/io/losses.h"
#include "core/io/point_lines.h"
#include "core/io/row_blocks.h"

namespace stipple {

std::vector<std::string> writeOff(OutputFile& file, const PointSet& points, const WriteOptions&,
                                  Progress& progress) {
  const Attribute* color = findOfType(points, "color", AttributeType::kColor);
  const Attribute* normal = findOfType(points, "normal", AttributeType::kVector3);
  const std::span<const Triangle> triangles = points.triangles();
  TextBuffer text;
  PointLines lines(points, text);
  RowBlocks rows(file, points.size() + triangles.size(), progress);
  file.write(fmt::format("{}{}OFF\n{} {} 0\n", color ? "C" : "", normal ? "N" : "", points.size(),
                         triangles.size()));
  rows.writeLines(points.size(), text, [&](std::size_t row) {
    lines.appendPosition(row);
    if (normal) lines.appendVector(normal->column.view<Eigen::Vector3f>()[row]);
    if (color) {
      const Rgba8& value = color->column.view<Rgba8>()[row];
      lines.appendBytes(value);
      text.append(' ').append(std::uint32_t{value.a});
    }
    text.append('\n');
  });
  rows.writePolygons(triangles, text);
  return lossesOf(points, {.attributes = {"color", "normal"}, .triangles = true, .alpha = true});
}

}  // namespace stipple
