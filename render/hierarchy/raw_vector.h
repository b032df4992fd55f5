#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/large_pages.h"

namespace stipple {

/// Leaves elements that are not given a value as they are, even those whose type has values by default: pages
/// of large arrays, large ones, are touched first by the threads that fill them.
template <class T>
struct RawAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = RawAllocator<U>;
  };
  T* allocate(std::size_t count) {
    T* memory = std::allocator<T>::allocate(count);
    askForLargePages(memory, count * sizeof(T));
    return memory;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) > 0) {
      ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    } else if constexpr (!std::is_aggregate_v<U> || !std::is_trivially_destructible_v<U>) {
      ::new (static_cast<void*>(place)) U;  // an aggregate lives as soon as its memory is allocated
    }
  }
};
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace stipple
