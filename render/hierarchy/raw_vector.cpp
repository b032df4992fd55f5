#include "render/hierarchy/raw_vector.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace stipple {

namespace {

constexpr std::align_val_t kLargePage{std::size_t{1} << 21};
// From here on the rest of the last page is little.
constexpr std::size_t kLarge = std::size_t{1} << 24;

}  // namespace

void* allocateRaw(std::size_t bytes) {
  if (bytes < kLarge) return ::operator new(bytes);
  void* memory = ::operator new(bytes, kLargePage);
#ifdef MADV_HUGEPAGE
  madvise(memory, bytes, MADV_HUGEPAGE);  // a wish
#endif
  return memory;
}

void freeRaw(void* memory, std::size_t bytes) {
  bytes < kLarge ? ::operator delete(memory) : ::operator delete(memory, kLargePage);
}

}  // namespace stipple
