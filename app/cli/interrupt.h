#pragma once

namespace stipple {

/// From now on Ctrl+C, and a request to terminate or a closed terminal, only sets a flag that commands look
/// at.
void catchInterrupts();
bool wasInterrupted();

}  // namespace stipple
