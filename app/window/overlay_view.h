#pragma once

#include <QElapsedTimer>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/panels/overlay.h"
#include "app/tools/brush_settings.h"
#include "app/view/frame_maker.h"

namespace stipple {

struct OpenScan;
struct ProcessState;
class PointColors;

/// A line over the picture, pixels.
struct ScreenLine {
  std::vector<glm::vec2> points;
  bool isClosed = false;
  Rgba8 color{255, 255, 255, 255};
};
struct ScreenText {
  glm::vec2 at{};
  std::string text;
};

/// What the overlay shows, from the state of everything else, and what it remembers from frame to frame: the
/// message of the moment, times of frames, counts for the legend.
class OverlayView {
 public:
  bool showsStatistics = false;
  std::vector<HintCard> cards = {};  ///< of the first start

  void say(std::string sentence, std::string details);
  const std::string& details() const { return details_; }
  void noteFrame(const FrameNotes& notes);

  void showBrush(const BrushSettings& settings, bool isSelecting, const OpenScan& scan);
  void hideBrush() { model_.brush.reset(); }
  void showProcess(const std::optional<ProcessState>& process);
  void showLegend(const OpenScan* scan);
  void showStatistics(const OpenScan* scan, const std::optional<FrameNotes>& notes, const char* backend);

  /// Between a context's beginFrame and endFrame. The attribute index of brush actions is one of
  /// paintedAttributes().
  OverlayActions draw(const std::vector<ScreenLine>& lines, const std::vector<ScreenText>& texts);
  const std::vector<std::string>& paintedAttributes() const { return painted_; }
  /// Something on it moves by itself: draw again soon.
  bool isAnimated() const;

 private:
  void showPaint(const BrushSettings& settings, const OpenScan& scan);
  void countLabels(const OpenScan& scan, const std::string& attribute);

  OverlayModel model_;
  std::vector<std::string> painted_;
  std::vector<Rgba8> recentColors_;
  std::string sentence_, details_;
  QElapsedTimer said_;
  std::vector<float> frameTimes_;
  std::uint64_t countedColumn_ = 0;
};

/// What the user chose in the brush panel, put into the settings. False where that is nothing.
bool applyBrushActions(const BrushActions& actions, const std::vector<std::string>& attributes,
                       const OpenScan& scan, BrushSettings& settings);

}  // namespace stipple
