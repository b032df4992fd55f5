#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "render/appearance/appearance.h"
#include "render/appearance/image.h"
#include "render/appearance/surface_mesh.h"
#include "render/hierarchy/cut.h"
#include "render/hierarchy/refit.h"

namespace stipple {

/// What lies under a pixel of the last frame.
struct Pick {
  Index node = 0;        ///< of the hierarchy
  float depth = 0;       ///< along the view direction, world units
  glm::vec3 position{};  ///< world
};

enum class Accumulate { kStartAnew, kAddToMean };

/// Draws cuts of a hierarchy. One thread at a time; the `gl` back end needs its context to be current in
/// every call, destruction included.
class Renderer {
 public:
  virtual ~Renderer() = default;
  /// "cpu" or "gl".
  virtual const char* backend() const = 0;

  /// To be called before drawing a hierarchy for the first time (all nodes), and for ranges that changed
  /// since.
  virtual void upload(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed) = 0;

  /// Draws one whole frame; with kAddToMean the picture is the mean of all frames since the last kStartAnew,
  /// in linear light. Where it throws Cancelled, the last picture stays as it was.
  virtual void draw(const Hierarchy& hierarchy, const std::vector<Index>& nodes, const View& view,
                    const Appearance& appearance, Accumulate accumulate,
                    const Progress* progress = nullptr) = 0;
  /// After draw(): the same nodes, view and appearance again, where only what is in `changed` (ascending)
  /// differs, as under a brush. Starts the mean anew where it was drawn into. To be called after upload().
  virtual void redraw(const Hierarchy& hierarchy, const std::vector<NodeRange>& changed) = 0;
  /// The same as draw() for triangles, shaded with the normals of their corners.
  virtual void drawMesh(const SurfaceMesh& mesh, const View& view, const Appearance& appearance,
                        Accumulate accumulate, const Progress* progress = nullptr) = 0;

  /// The picture, over the background.
  virtual Image image() = 0;
  /// Nothing where the background shows, and after drawMesh.
  virtual std::optional<Pick> pick(int x, int y) = 0;
  /// Of the last frame, of splats and triangles: world units along the line of sight by pixel, rows from the
  /// top, infinite where the background shows.
  virtual std::vector<float> depth() = 0;
};

enum class Backend { kAuto, kCpu, kGl };

/// kAuto: `gl` where a current context is OpenGL 4.5 on hardware, otherwise `cpu`. Throws IoError where `gl`
/// is asked for and no current context offers it.
std::unique_ptr<Renderer> makeRenderer(Backend backend);

}  // namespace stipple
