#pragma once

/// Starts a screen that nobody sees (Xvfb) for this process and those that it starts; it goes
/// with the process. Windows never appear on the screen of whoever runs the tests. Returns false, having said
/// why, where there is none to be had.
bool startVirtualScreen(int width = 1280, int height = 840);

/// Makes the user's folders (configuration, cache, data, home) new empty ones, which go with the process.
void useEmptyHome();
