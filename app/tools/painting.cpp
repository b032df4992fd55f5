#include "app/tools/painting.h"

#include <fmt/format.h>

#include <utility>

namespace stipple {

namespace {

std::string titleOf(const Stroke& stroke) {
  const char* verb = stroke.tool == StrokeTool::kErase    ? "Erase"
                     : stroke.tool == StrokeTool::kSmooth ? "Smooth"
                                                          : "Paint";
  return fmt::format("{} {}", verb, stroke.attribute);
}

}  // namespace

void Painting::begin(Document& document, std::shared_ptr<const SurfaceDistance> surface, const Stroke& stroke,
                     PointFilter filter) {
  stroke_ = stroke;
  stroke_.dabs.clear();
  leftOut_ = std::make_shared<bool>(false);
  filter_ = {};
  if (filter) {
    filter_ = [leftOut = leftOut_, inner = std::move(filter)](Index point) {
      const bool isIn = inner(point);
      if (!isIn) *leftOut = true;
      return isIn;
    };
  }
  StrokePainter painter(std::move(surface), stroke_);
  document.beginStroke(titleOf(stroke_));
  painter_.emplace(std::move(painter));
}

void Painting::lay(Document& document, std::span<const Dab> dabs) {
  for (const Dab& dab : dabs) {
    document.paint([&](PointSet& points) { return painter_->lay(points, dab, filter_); });
    stroke_.dabs.push_back(dab);
  }
}

void Painting::end(Document& document) {
  painter_.reset();
  if (*leftOut_)
    document.endStroke({});
  else
    document.endStroke(Recipe::Step(std::exchange(stroke_, {})));
}

void Painting::cancel(Document& document) {
  painter_.reset();
  document.cancelStroke();
}

}  // namespace stipple
