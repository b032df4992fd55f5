#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/document/stroke.h"
#include "app/tools/brush_settings.h"
#include "app/tools/dab_path.h"
#include "app/tools/pick_at.h"
#include "app/tools/pointer_event.h"
#include "render/hierarchy/view.h"

namespace stipple {

/// The picture that the brush works on.
struct BrushCanvas {
  const View& view;
  const PickAt& pickAt;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< file coordinates of the world's origin
  float emptyDepth = 1;  ///< where sizes are measured while nothing is under the pointer: the pivot's depth
};

enum class StrokePhase { kNone, kBegins, kGoesOn, kEnds, kCancelled };

/// What came of an event.
struct BrushResponse {
  bool taken = false;   ///< else the event is the camera's
  bool redraw = false;  ///< the ring or a setting changed
  StrokePhase phase = StrokePhase::kNone;
  std::vector<Dab> dabs = {};  ///< new ones, in file coordinates, each followed by its mirror image if any
};

/// A running stroke without its dabs.
struct BrushStroke {
  BrushKind kind = BrushKind::kPaint;
  Stroke stroke = {};  ///< the tool is `kind`, or paint where it smooths
  bool onlyVisible = false;
  std::string within = {};
};

/// A circle on the surface under the pointer.
struct SurfaceRing {
  glm::vec3 center{};  ///< world
  float radius = 0;    ///< world units
};

enum class BrushAdjustment { kNone, kRadius, kStrength };

/// Turns events into dabs. A left press on the surface begins a stroke (with ctrl inverted, with shift
/// smoothing), moves lay dabs, the release ends it; what begins beside the surface or is always the camera's
/// is not taken. Alt and the wheel change the size.
class BrushTool {
 public:
  const BrushSettings& settings() const { return settings_; }
  /// A running stroke keeps those it began with.
  void set(BrushSettings settings) { settings_ = std::move(settings); }

  BrushResponse handle(const PointerEvent& event, const BrushCanvas& canvas);
  /// Ends the stroke or the adjustment and takes it back (Esc, or the document refuses it).
  BrushResponse cancel();

  bool isStroking() const { return running_.has_value(); }
  /// Of the stroke that runs, or ran last.
  const BrushStroke& stroke() const { return stroke_; }
  const std::optional<SurfaceRing>& ring() const { return ring_; }

  /// One step is a tenth of the size: keys [ and ].
  void stepSize(float steps, const BrushCanvas& canvas);
  /// Until the left button is released (or cancel), moves to the right enlarge the radius by as many pixels,
  /// or the strength by one in 300 pixels: F, and Shift+F. Not during a stroke.
  void beginAdjusting(BrushAdjustment what, const glm::vec2& px, const BrushCanvas& canvas);
  void confirmAdjusting() { adjusting_.reset(); }
  BrushAdjustment adjusting() const { return adjusting_ ? adjusting_->what : BrushAdjustment::kNone; }

 private:
  struct Running {
    DabPath path;
    BrushSettings settings;
    float pressure;  // last reported
  };
  struct Adjusting {
    BrushAdjustment what;
    BrushSettings before;
    glm::vec2 px;
    double radiusPx;  // at first
    float pixelsPerUnit;
  };

  BrushResponse begin(const PointerEvent& event, const BrushCanvas& canvas);
  BrushResponse goOn(const PointerEvent& event, const BrushCanvas& canvas);
  BrushResponse adjust(const PointerEvent& event);
  BrushResponse hover(const PointerEvent& event, const BrushCanvas& canvas);
  void addDabs(std::span<const PathDab> path, const BrushCanvas& canvas, BrushResponse& response) const;
  void setRadiusPx(double radiusPx, float pixelsPerUnit);
  float sizingScale(const BrushCanvas& canvas) const;

  BrushSettings settings_;
  BrushStroke stroke_;
  std::optional<Running> running_;
  std::optional<Adjusting> adjusting_;
  std::optional<SurfaceRing> ring_;
};

}  // namespace stipple
