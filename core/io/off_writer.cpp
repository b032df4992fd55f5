#include "core/io/off_writer.h"

#include <fmt/format.h>

#include "core/io/losses.h"
#include "core/io/point_lines.h"

namespace stipple {

namespace {

constexpr Index kRowsPerBlock = 1 << 14;

}  // namespace

std::vector<std::string> writeOff(OutputFile& file, const PointSet& points, const WriteOptions&,
                                  Progress& progress) {
  const Attribute* color = findOfType(points, "color", AttributeType::kColor);
  const Attribute* normal = findOfType(points, "normal", AttributeType::kVector3);
  TextBuffer text;
  PointLines lines(points, text);
  text.append(fmt::format("{}{}OFF\n{} {} 0\n", color ? "C" : "", normal ? "N" : "", points.size(),
                          points.triangles().size()));
  for (Index row = 0; row < points.size(); ++row) {
    lines.appendPosition(row);
    if (normal) lines.appendVector(normal->column.view<Eigen::Vector3f>()[row]);
    if (color) {
      const Rgba8& value = color->column.view<Rgba8>()[row];
      lines.appendBytes(value);
      text.append(' ').append(std::uint32_t{value.a});
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
    text.append('3');
    for (const Index corner : triangle) text.append(' ').append(corner);
    file.write(text.append('\n').view());
    text.clear();
  }
  file.write(text.view());
  return lossesOf(points, {.attributes = {"color", "normal"}, .triangles = true, .alpha = true});
}

}  // namespace stipple
