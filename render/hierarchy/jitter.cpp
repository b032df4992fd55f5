#include "render/hierarchy/jitter.h"

namespace stipple {

namespace {

// The digits of the index in the base, mirrored behind the point.
float mirrored(int index, int base) {
  float value = 0, place = 1;
  for (; index > 0; index /= base) {
    place /= static_cast<float>(base);
    value += place * static_cast<float>(index % base);
  }
  return value;
}

}  // namespace

glm::vec2 jitterOfFrame(int index) {
  return {mirrored(index + 1, 2) - 0.5f, mirrored(index + 1, 3) - 0.5f};
}

}  // namespace stipple
