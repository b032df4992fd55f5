#pragma once

#include <chrono>

#include "core/progress.h"

namespace stipple {

/// Draws a bar on stderr where that is a terminal; stops the command on Ctrl+C.
class TerminalProgress final : public Progress {
 public:
  TerminalProgress();
  ~TerminalProgress() override { clear(); }
  void report(double fraction, std::string_view message) override;
  bool cancelled() const override;
  /// Takes the bar away, so that something else can be printed.
  void clear();

 private:
  bool isTerminal_;
  bool isDrawn_ = false;
  std::chrono::steady_clock::time_point lastDrawn_{};
};

}  // namespace stipple
