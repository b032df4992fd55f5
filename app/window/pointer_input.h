#pragma once

#include <QEvent>
#include <optional>

#include "app/panels/overlay_context.h"
#include "app/tools/pointer_event.h"

class QKeyEvent;

namespace stipple {

/// What a mouse, pen or wheel event of Qt is for the tools; nothing for other events. `ratio`: device pixels
/// of a pixel of the widget.
std::optional<PointerEvent> pointerEventOf(const QEvent& event, double ratio);

/// Feeds an event of the viewport's widget to the overlay.
void feedOverlay(OverlayContext& overlay, const PointerEvent& event);
void feedOverlay(OverlayContext& overlay, const QKeyEvent& event);

}  // namespace stipple
