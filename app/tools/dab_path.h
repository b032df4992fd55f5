#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "app/tools/pick_at.h"
#include "render/hierarchy/view.h"

namespace stipple {

/// A place on the surface where a stroke touches it.
struct PathDab {
  glm::vec3 position{};  ///< world
  float pressure = 1;
};

/// A light touch of a pen that scales the size still has this share of it.
inline constexpr float kLeastPenSize = 0.1f;

struct DabPathOptions {
  float radius = 1;                   ///< of the brush, world units
  float spacing = 0.25f;              ///< in radii
  bool pressureScalesRadius = false;  ///< spacing follows
};

/// Lays dabs at even spacing along the way of a pointer over the surface. Every dab is at a place that was
/// picked; where the way leaves the surface or jumps to another part of it, it begins anew there.
class DabPath {
 public:
  DabPath() = default;
  /// The first dab is where the path begins.
  DabPath(const DabPathOptions& options, const glm::vec2& px, const Picked& picked, float pressure);

  /// The dabs on the way of the pointer from where it was to here; the pressure changes evenly.
  std::vector<PathDab> extendTo(const glm::vec2& px, float pressure, const View& view, const PickAt& pickAt);
  /// Where the path last was on the surface.
  const glm::vec3& lastPlace() const { return last_.picked.position; }

 private:
  struct Station {
    glm::vec2 px{};
    Picked picked;
    float pressure = 1;
  };
  float spacingAt(float pressure, float depth, const View& view) const;
  bool isGap(const Station& next, const View& view) const;
  void goOn(const Station& next, float spacing, const PickAt& pickAt, std::vector<PathDab>& dabs);
  void beginPiece(const Station& next, float spacing, std::vector<PathDab>& dabs);

  DabPathOptions options_;
  glm::vec2 px_{};  // how far the pointer's way is done, on the surface or not
  float pressure_ = 1;
  Station last_;           // where it last was on the surface
  bool onSurface_ = true;  // it still is there
  float travelled_ = 0;    // since the last dab, world units
  glm::vec3 lastDab_{};
};

}  // namespace stipple
