#pragma once

#include <string>
#include <vector>

#include "render/hierarchy/cut.h"
#include "render/splat/renderer.h"
#include "tests/support/picture_errors.h"

namespace stipple {

/// A surface, and the splats that stand for it.
struct CoverageSubject {
  const Hierarchy& hierarchy;
  const scenes::RaySurface& truth;
  float spacing = 0;  ///< of the points, world units
};

struct CoverageOptions {
  int side = 320;                        ///< pixels of the square pictures
  int directions = 20;                   ///< of 20, spread evenly
  std::vector<float> zooms{0.4f, 1, 2};  ///< far, just fitting, near
  float tau = 3;
};

/// Stray pixels of one view.
struct CoverageView {
  CameraAngles angles;
  PictureErrors errors;

  int stray() const { return errors.holes + errors.seeThrough; }
};

/// Holes and backs that show, in all views; `see-through` from three spacings on.
std::vector<CoverageView> lookFromAllSides(Renderer& renderer, const CoverageSubject& subject,
                                           const CoverageOptions& options);

/// The view with the most stray pixels, in words.
std::string describeWorst(const std::vector<CoverageView>& views);

}  // namespace stipple
