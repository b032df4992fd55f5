#include "core/io/obj_writer.h"

#include "core/io/losses.h"
#include "core/io/point_lines.h"

namespace stipple {

namespace {

constexpr Index kRowsPerBlock = 1 << 14;

}  // namespace

std::vector<std::string> writeObj(OutputFile& file, const PointSet& points, const WriteOptions&,
                                  Progress& progress) {
  const Attribute* color = findOfType(points, "color", AttributeType::kColor);
  const Attribute* normal = findOfType(points, "normal", AttributeType::kVector3);
  TextBuffer text;
  PointLines lines(points, text);
  text.append("# written by Stipple\n");
  for (Index row = 0; row < points.size(); ++row) {
    text.append("v ");
    lines.appendPosition(row);
    if (color) lines.appendFractions(color->column.view<Rgba8>()[row]);
    if (normal) {
      text.append("\nvn");
      lines.appendVector(normal->column.view<Eigen::Vector3f>()[row]);
    }
    text.append('\n');
    if (row % kRowsPerBlock == 0) {
      file.write(text.view());
      text.clear();
      progress.throwIfCancelled();
      progress.report(static_cast<double>(row) / points.size(), "writing");
    }
  }
  for (const Triangle& triangle : points.triangles()) {
    text.append('f');
    for (const Index corner : triangle) {
      text.append(' ').append(corner + 1);
      if (normal) text.append("//").append(corner + 1);
    }
    file.write(text.append('\n').view());
    text.clear();
  }
  file.write(text.view());
  return lossesOf(points, {.attributes = {"color", "normal"}, .triangles = true});
}

}  // namespace stipple
