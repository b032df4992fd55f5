#pragma once

#include <chrono>
#include <thread>

/// Asks until it is so, for half a minute at most: sanitized programs on busy machines are slow.
template <class Condition>
bool waitUntil(Condition&& isSo) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!isSo()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}
