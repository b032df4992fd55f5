#pragma once

class QWidget;

namespace stipple {

/// The wheel over a field scrolls the panel that it is in, and does not change the field in passing.
void leaveWheelToPanel(QWidget* field);

}  // namespace stipple
