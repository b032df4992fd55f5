#include "core/io/obj_writer.h"

#include "core/io/losses.h"
#include "core/io/point_lines.h"
#include "core/io/row_blocks.h"

namespace stipple {

std::vector<std::string> writeObj(OutputFile& file, const PointSet& points, const WriteOptions&,
                                  Progress& progress) {
  const Attribute* color = findOfType(points, "color", AttributeType::kColor);
  const Attribute* normal = findOfType(points, "normal", AttributeType::kVector3);
  const std::span<const Triangle> triangles = points.triangles();
  TextBuffer text;
  PointLines lines(points, text);
  RowBlocks rows(file, points.size() + triangles.size(), progress);
  file.write("# written by Stipple\n");
  rows.writeLines(points.size(), text, [&](std::size_t row) {
    text.append("v ");
    lines.appendPosition(row);
    if (color) lines.appendFractions(color->column.view<Rgba8>()[row]);
    if (normal) {
      text.append("\nvn");
      lines.appendVector(normal->column.view<Eigen::Vector3f>()[row]);
    }
    text.append('\n');
  });
  rows.writeLines(triangles.size(), text, [&](std::size_t row) {
    text.append('f');
    for (const Index corner : triangles[row]) {
      text.append(' ').append(corner + 1);
      if (normal) text.append("//").append(corner + 1);
    }
    text.append('\n');
  });
  return lossesOf(points, {.attributes = {"color", "normal"}, .triangles = true});
}

}  // namespace stipple
