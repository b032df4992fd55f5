#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace stipple {

/// Memory that is not touched; where it is large, in large pages if the system has them to give: random
/// access to gigabytes of small pages waits for addresses longer than for values.
void* allocateRaw(std::size_t bytes);
void freeRaw(void* memory, std::size_t bytes);

/// Leaves elements that are not given a value as they are: pages of large arrays are touched first by the
/// threads that fill them.
template <class T>
struct RawAllocator {
  using value_type = T;
  RawAllocator() = default;
  template <class U>
  RawAllocator(const RawAllocator<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocateRaw(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) { freeRaw(memory, count * sizeof(T)); }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0) {
      ::new (static_cast<void*>(place)) U;
    } else {
      ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }
  }
  friend bool operator==(const RawAllocator&, const RawAllocator&) { return true; }
};
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace stipple
