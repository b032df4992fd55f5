#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/overlay_context.h"
#include "app/tools/brush_tool.h"
#include "app/tools/inspection_drawing.h"
#include "app/tools/navigation.h"
#include "app/tools/painting.h"
#include "app/window/overlay_view.h"
#include "app/window/theme.h"
#include "app/window/viewport.h"
#include "plugins/api/operator.h"

class QKeyEvent;

namespace stipple {

class Workbench;

enum class SelectionChange { kAll, kNone, kInvert, kGrow, kShrink };
enum class Tool { kOrbit, kPaint, kErase, kSmooth, kSelect, kRectangle, kLasso, kMeasure, kInspect };

/// Between the viewport and everything else: input goes to the overlay, the tool at hand or the camera;
/// changes of the current scan go to the picture.
class ViewController final : public QObject {
  Q_OBJECT

 public:
  ViewController(Workbench& workbench, std::unique_ptr<Viewport> viewport, QObject* parent);
  ~ViewController() override;

  Viewport& viewport() { return *viewport_; }
  OverlayView& overlay() { return overlayView_; }

  Tool tool() const { return tool_; }
  void setTool(Tool tool);
  /// What the brush paints, as an operator's declared input asks for it.
  void paintAttribute(const std::string& attribute, std::vector<double> value,
                      PaintKind kind = PaintKind::kLabels);
  const BrushSettings& brush() const { return brush_.settings(); }
  void setBrush(const BrushSettings& settings);

  void frameModel();
  void applyViewKey(int digit, bool opposite);
  void toggleProjection();
  void setUpAxis(UpAxis up);
  void setMode(SplatMode mode);
  void setTheme(Theme theme);
  void relook();
  void showStatistics(bool isShown);
  void changeSelection(SelectionChange change);
  void selectByValue(const std::string& attribute, double low, double high);
  /// True where Esc had something to end.
  bool escape();

  const Appearance& appearance() const { return appearance_; }

 signals:
  void toolChanged();
  void pictureChanged();
  /// A hint of the first start was chosen.
  void cardStarted(const QString& id);
  void strokeEnded(const std::string& attribute);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool handlePointer(const PointerEvent& event);
  bool handleKey(const QKeyEvent& event);
  bool handleBrush(const PointerEvent& event);
  bool handleOutline(const PointerEvent& event);
  bool handleClickTool(const PointerEvent& event);
  void beginPainting();
  void showPainted(const std::string& attribute);
  void followStroke(const BrushResponse& response);
  void endStroke();
  void selectOutline();
  void inspectAt(const Picked& picked);
  void measureTo(const Picked& picked);
  void measureAgain();
  void forgetPlaces();
  void navigate(const PointerEvent& event);
  void showCurrent();
  void followPoints();
  void followPreview(const PointSet& state);
  void postView();
  struct OverlayStep {
    OverlayActions actions;
    const ImDrawData& drawing;
  };
  OverlayStep stepOverlay();
  const ImDrawData& drawOverlay();
  void applyOverlay(const OverlayActions& actions);
  void fillOverlay();
  std::vector<ScreenLine> overlayLines() const;
  std::vector<ScreenText> overlayTexts() const;
  PictureSize pictureSize() const;
  PickAt picker();
  bool isBrush() const {
    return tool_ == Tool::kPaint || tool_ == Tool::kErase || tool_ == Tool::kSmooth || tool_ == Tool::kSelect;
  }
  BrushCanvas canvas(const PickAt& pickAt) const;
  void askForDistance();
  void updateCursor();

  Workbench& workbench_;
  OverlayContext overlayContext_;
  std::unique_ptr<Viewport> viewport_;
  OverlayView overlayView_;
  Appearance appearance_;
  Tool tool_ = Tool::kOrbit;
  Navigation navigation_;
  BrushTool brush_;
  Painting painting_;
  std::vector<glm::vec2> outline_;  // of the rectangle (two corners) or lasso that is being drawn
  Modifiers outlineModifiers_;
  std::vector<Picked> measured_;         // one or two places
  std::vector<glm::vec3> measuredPath_;  // along the surface
  std::string measuredText_;
  std::optional<Picked> inspected_;
  std::vector<ColoredSegment> inspectedLines_;
  std::string inspectedText_;
  std::string maskAttribute_;    // painted as a mask: shown over the colors
  BrushSettings paintSettings_;  // while the selection brush is at hand
  std::optional<glm::vec2> mouse_;
  bool overlayHasMouse_ = false;
  mutable View shownView_;  // of the last picture, for the canvas of the brush
  QElapsedTimer overlayClock_;
};

}  // namespace stipple
