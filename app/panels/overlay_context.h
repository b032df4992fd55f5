#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>

#include "app/panels/overlay_input.h"
#include "app/panels/pixel_target.h"
#include "app/panels/theme.h"

struct ImDrawData;

namespace stipple {

/// One Dear ImGui context with its fonts, look and input: one for each viewport. Positions and sizes are in
/// device pixels. All contexts belong to one thread, and frames do not nest: Dear ImGui keeps the current
/// context in a global.
///
/// Input may come at any time; it acts in the next frame, and a click shorter than a frame is not lost.
class OverlayContext {
 public:
  explicit OverlayContext(const OverlayLook& look = {});
  ~OverlayContext();
  OverlayContext(OverlayContext&&) noexcept;
  OverlayContext& operator=(OverlayContext&&) noexcept;

  const OverlayLook& look() const;
  /// Between frames. Another scale makes another atlas.
  void setLook(const OverlayLook& look);

  void moveMouse(glm::vec2 position);
  void leaveMouse();
  void setButton(OverlayButton button, bool isDown);
  void turnWheel(float notches);
  void setModifiers(const OverlayModifiers& modifiers);
  void setKey(OverlayKey key, bool isDown);
  void typeCharacter(char32_t character);
  /// Something was fed that no frame has seen to its end: draw one.
  bool hasPendingInput() const;
  /// A panel that came in the last frame is laid out, but shown by the next only: draw it.
  bool hasHiddenPanels() const;

  /// Panels are drawn between the two. `seconds` since the last frame. The drawing lives until the next
  /// frame.
  void beginFrame(glm::ivec2 size, float seconds);
  const ImDrawData& endFrame();

  /// Mouse events are the overlay's, not the camera's or the tool's: the mouse is over a panel, or was when a
  /// button went down that still is.
  bool wantsMouse() const;
  /// A field of the overlay is being typed into, or a popup waits for Escape.
  bool wantsKeyboard() const;
  OverlayCursor cursor() const;

  AlphaTexture atlas() const;
  /// Grows with each new atlas: a back end that keeps it as a texture makes that anew.
  std::uint64_t atlasRevision() const;
  /// For Dear ImGui's own back ends, which act on the current context.
  void makeCurrent() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stipple
