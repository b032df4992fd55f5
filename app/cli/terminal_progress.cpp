#include "app/cli/terminal_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/cli/interrupt.h"

namespace stipple {

namespace {

constexpr int kBarWidth = 30;
constexpr std::chrono::milliseconds kRedrawInterval{100};

}  // namespace

TerminalProgress::TerminalProgress() : isTerminal_(isatty(STDERR_FILENO) == 1) {}

void TerminalProgress::report(double fraction, std::string_view message) {
  const auto now = std::chrono::steady_clock::now();
  if (!isTerminal_ || now - lastDrawn_ < kRedrawInterval) return;
  lastDrawn_ = now;
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kBarWidth);
  fmt::print(stderr, "\r\x1b[K[{:#<{}}{:.<{}}] {:3.0f} % {}", "", filled, "", kBarWidth - filled,
             100 * fraction, message);
  std::fflush(stderr);
  isDrawn_ = true;
}

bool TerminalProgress::cancelled() const {
  return wasInterrupted();
}

void TerminalProgress::clear() {
  if (isDrawn_) fmt::print(stderr, "\r\x1b[K");
  isDrawn_ = false;
}

}  // namespace stipple
