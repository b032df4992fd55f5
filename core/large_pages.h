#pragma once

#include <cstddef>
#include <vector>

namespace stipple {

/// Asks for large pages under memory that nobody has touched yet, where the system has them to give: they are
/// handed out faster, and random access to gigabytes of small pages waits for addresses longer than for
/// values. Does nothing for less than some megabytes.
void askForLargePages(void* memory, std::size_t bytes);

/// Resizes; room that is new for that comes in large pages.
template <class T, class... Value>
void resizeInLargePages(std::vector<T>& values, std::size_t count, const Value&... value) {
  if (count > values.capacity() && values.empty()) {
    values.reserve(count);
    askForLargePages(values.data(), count * sizeof(T));
  }
  values.resize(count, value...);
}

}  // namespace stipple
