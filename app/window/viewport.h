#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/tools/pick_at.h"
#include "app/view/frame_maker.h"

struct ImDrawData;
class QWidget;

namespace stipple {

class OverlayContext;

/// The widget that shows the surface: one for each back end, the same for everybody else. All sizes are
/// device pixels. The widget belongs to its Qt parent; input is taken from it by an event filter.
class Viewport {
 public:
  virtual ~Viewport() = default;
  virtual QWidget& widget() = 0;
  virtual const char* backend() const = 0;

  virtual void post(SceneChange change, std::uint64_t revision) = 0;
  virtual void setView(const View& view) = 0;
  virtual void setAppearance(const Appearance& appearance) = 0;

  /// Of the last picture; nothing before the first.
  virtual std::optional<FrameNotes> notes() const = 0;
  virtual std::optional<Picked> pickAt(const glm::vec2& px) = 0;
  /// By pixel of notes()->view, infinite where the background shows.
  virtual std::vector<float> depthPicture() = 0;
  virtual Image picture() = 0;

  /// Drawn over the picture whenever it is painted, at the widget's present size.
  std::function<const ImDrawData&()> overlay;
  /// Of that drawing.
  const OverlayContext* overlayContext = nullptr;
  /// Called after a new picture is there.
  std::function<void()> pictureChanged;
  /// Called with a sentence when drawing fails.
  std::function<void(const std::string&)> failed;
};

enum class ViewportKind { kAuto, kCpu, kGl };

/// kAuto: `gl` where OpenGL 4.5 runs on hardware, else `cpu`. Where `gl` is asked for and is not to be had,
/// it is `cpu`, and `complaint` says so.
std::unique_ptr<Viewport> makeViewport(ViewportKind kind, QWidget* parent, std::string* complaint);

}  // namespace stipple
