#pragma once

#include <string>

#include "app/panels/panel_window.h"

namespace stipple {

enum class MessageKind { kNote, kError };

/// A line at the bottom that never blocks.
struct MessageModel {
  std::string text;
  MessageKind kind = MessageKind::kNote;
  bool hasDetails = false;
  float ageSeconds = 0;
};

struct MessageActions {
  bool showDetails = false;
  bool dismiss = false;  ///< by the user, or because a note has faded
};

/// Notes fade after some seconds, and not while the mouse is over them; errors stay until they are dismissed.
MessageActions drawMessageLine(const MessageModel& model, const PanelPlace& place);

/// 1, falling to 0 at the end of a message's time.
float opacityOf(const MessageModel& model);

}  // namespace stipple
