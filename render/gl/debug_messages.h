#pragma once

#include <mutex>
#include <string>
#include <vector>

namespace stipple::gl {

/// Collects what the driver of the current context complains about (errors, undefined behavior, high
/// severity) while it lives. Complete only in debug contexts. Replaces another debug callback.
class DebugMessages {
 public:
  DebugMessages();
  ~DebugMessages();
  DebugMessages(const DebugMessages&) = delete;
  DebugMessages& operator=(const DebugMessages&) = delete;

  /// Those since the last call.
  std::vector<std::string> take();
  void add(std::string message);

 private:
  std::mutex mutex_;  // some drivers report from threads of their own
  std::vector<std::string> messages_;
};

/// Drops error flags that calls of others left behind.
void forgetErrors();

}  // namespace stipple::gl
