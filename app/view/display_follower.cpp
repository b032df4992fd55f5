#include "app/view/display_follower.h"

#include <algorithm>
#include <atomic>

namespace stipple {

namespace {

constexpr const char* kSelection = "selection";

// Above that share of the points coloring all of them is as fast.
constexpr std::size_t kFewOfAll = 4;

ColumnId columnOf(const PointSet& points, const char* name) {
  const Attribute* attribute = points.find(name);
  return attribute ? attribute->column.id() : 0;
}

// Surfaces of all views have numbers of their own.
std::uint64_t newSurfaceNumber() {
  static std::atomic<std::uint64_t> next{1};
  return next++;
}

bool isScalar(const Attribute& attribute) {
  return attribute.type() != AttributeType::kColor && attribute.type() != AttributeType::kVector3;
}

}  // namespace

Look DisplayFollower::fitting(const PointSet& points, Look look) const {
  ColorSource& colors = look.colors;
  if (!colors.attribute.empty() && !points.has(colors.attribute)) colors = {};
  const Attribute* saturation = points.find(colors.saturationBy);
  if (!colors.saturationBy.empty() && (!saturation || !isScalar(*saturation))) colors.saturationBy.clear();
  const std::string marked = look.marked.empty() ? kSelection : look.marked;
  const Attribute* selection = points.find(marked);
  colors.selection = selection && isScalar(*selection) ? marked : "";
  const Attribute* glyphs = points.find(look.glyphs);
  if (!glyphs || glyphs->type() != AttributeType::kVector3) look.glyphs.clear();
  return look;
}

void DisplayFollower::remember(const PointSet& points) {
  positions_ = points.positionColumn().id();
  normals_ = columnOf(points, "normal");
  displayNormals_ = columnOf(points, "display_normal");
  size_ = points.size();
}

SceneChange DisplayFollower::show(const PointSet& points, const Look& look) {
  wanted_ = look;
  look_ = fitting(points, look);
  colors_ = PointColors(points, look_.colors);
  remember(points);
  surface_ = newSurfaceNumber();
  return NewSurface{.surface = surface_,
                    .points = points,
                    .colors = colors_,
                    .glyphs = look_.glyphs,
                    .asMesh = look_.asMesh};
}

Restate DisplayFollower::restate(const PointSet& points, bool moved) {
  look_ = fitting(points, wanted_);
  colors_ = PointColors(points, look_.colors);
  remember(points);
  if (moved) surface_ = newSurfaceNumber();
  return Restate{.surface = surface_,
                 .points = points,
                 .colors = colors_,
                 .glyphs = look_.glyphs,
                 .asMesh = look_.asMesh,
                 .moved = moved};
}

SceneChange DisplayFollower::restyle(const PointSet& points, const Look& look) {
  if (points.size() != size_) return show(points, look);
  wanted_ = look;
  return restate(points, moved(points));
}

bool DisplayFollower::moved(const PointSet& points) const {
  return positions_ != points.positionColumn().id() || normals_ != columnOf(points, "normal") ||
         displayNormals_ != columnOf(points, "display_normal");
}

std::string DisplayFollower::marked() const {
  return wanted_.marked.empty() ? kSelection : wanted_.marked;
}

bool DisplayFollower::shows(const std::string& column) const {
  const ColorSource& colors = look_.colors;
  const std::string shown = colors.attribute.empty() ? "color" : colors.attribute;
  return column == shown || column == colors.saturationBy || column == kSelection || column == look_.glyphs ||
         column == wanted_.colors.attribute;
}

std::optional<SceneChange> DisplayFollower::follow(const PointSet& points, const DocumentChange& change) {
  if (change.everything || points.size() != size_) return show(points, wanted_);
  if (moved(points)) return restate(points, true);
  if (change.triangles && look_.asMesh) return restate(points, false);
  std::vector<Index> rows;
  for (const Edit::Touched& touched : change.columns) {
    if (!shows(touched.name)) continue;
    const bool isLine = touched.name == look_.glyphs;
    const bool isNew = touched.name == marked() && look_.colors.selection.empty();
    if (!touched.rows || isLine || isNew || rows.size() + touched.rows->size() > points.size() / kFewOfAll) {
      return restate(points, false);
    }
    rows.insert(rows.end(), touched.rows->begin(), touched.rows->end());
  }
  if (rows.empty()) return {};
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  std::vector<Rgba8> colors = colors_.of(points, rows);
  return Recolor{.rows = std::move(rows), .colors = std::move(colors)};
}

std::optional<SceneChange> DisplayFollower::preview(const PointSet& points) {
  if (points.size() != size_) return {};
  return restate(points, moved(points));
}

}  // namespace stipple
