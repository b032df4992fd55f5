#include "app/document/stroke.h"

#include <memory>

#include "app/document/stroke_painter.h"

namespace stipple {

const char* nameOf(StrokeTool tool) {
  switch (tool) {
    case StrokeTool::kPaint:
      return "paint";
    case StrokeTool::kErase:
      return "erase";
    case StrokeTool::kSmooth:
      return "smooth";
  }
  return "";
}

PointSet applyStroke(const PointSet& points, const Stroke& stroke, Progress& progress) {
  PointSet painted = points;
  prepareStroke(painted, stroke);
  if (points.size() == 0 || stroke.dabs.empty()) return painted;
  const StrokePainter painter(std::make_shared<SurfaceDistance>(points, &progress), stroke);
  for (std::size_t d = 0; d < stroke.dabs.size(); ++d) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(d) / static_cast<double>(stroke.dabs.size()), "painting");
    painter.lay(painted, stroke.dabs[d]);
  }
  return painted;
}

}  // namespace stipple
