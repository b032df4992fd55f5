#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "app/view/displayed_surface.h"
#include "app/view/look.h"
#include "app/view/rate_control.h"
#include "render/hierarchy/cut.h"
#include "render/raster/glyphs.h"
#include "render/splat/renderer.h"

namespace stipple {

/// What is known of a picture.
struct FrameNotes {
  View view;           ///< at full size
  int coarseness = 1;  ///< a pixel of image and depth is so many of the view, in both directions
  Index splats = 0;    ///< drawn; 0: triangles
  float tau = 0;
  double milliseconds = 0;
  bool isConverged = false;    ///< nothing finer will come, but for antialiasing
  int averaged = 1;            ///< frames in the picture
  std::uint64_t surface = 0;   ///< number of what is shown
  std::uint64_t revision = 0;  ///< the latest of the changes that are in the picture
};

/// A finished picture.
struct Frame : FrameNotes {
  Image image;
  std::vector<float> depth;  ///< by pixel of the image, infinite where the background shows
};

/// Other points than before, or rows came or went.
struct NewSurface {
  std::uint64_t surface = 0;
  PointSet points;
  PointColors colors;
  std::string glyphs = {};  ///< vector attribute shown as lines
  bool asMesh = false;
};
/// All colors of the surface, of which positions may have moved too.
struct Restate {
  std::uint64_t surface = 0;  ///< another number than before where points moved
  PointSet points;
  PointColors colors;
  std::string glyphs = {};
  bool asMesh = false;
  bool moved = false;
};
/// Colors of some points, as under a brush.
struct Recolor {
  std::vector<Index> rows;
  std::vector<Rgba8> colors;
};
/// A better hierarchy of the surface of that number.
struct Refined {
  std::uint64_t surface = 0;
  Hierarchy hierarchy;
};
using SceneChange = std::variant<NewSurface, Restate, Recolor, Refined>;

/// Points whose hierarchy could be better.
struct Unrefined {
  std::uint64_t surface = 0;
  PointSet points;
  PointColors colors;
};

/// Keeps what is shown and makes pictures of it, piece by piece: something at once and in time while the view
/// or the surface changes, then finer, then the mean of 16 frames. Belongs to one thread; where the renderer
/// draws with OpenGL its context is current in every call.
class FrameMaker {
 public:
  using Clock = std::chrono::steady_clock;

  explicit FrameMaker(std::unique_ptr<Renderer> renderer);
  ~FrameMaker();

  void apply(SceneChange change, std::uint64_t revision, const Progress* progress);
  void setView(const View& view);
  void setAppearance(const Appearance& appearance);

  /// Does the next piece of work. True: the picture changed, see frame(). What refines a picture that is
  /// complete ends early where `interrupt` says so; what shows a change does not.
  bool step(const Progress* interrupt);
  /// When the next piece is due; nothing where the picture is as good as it gets.
  std::optional<Clock::time_point> nextDue() const;

  /// Once for every surface, when its first picture is complete and nothing moves: what a better hierarchy is
  /// to be made of. Nothing where that would take more than `refinementBudget`: then step() betters the one
  /// that there is, piece by piece.
  std::optional<Unrefined> takeUnrefined();
  FrameNotes notes() const;
  /// The last picture with its depth. Copies both from the back end.
  Frame frame();
  const char* backend() const { return renderer_->backend(); }
  const DisplayedSurface& surface() const { return surface_; }
  std::uint64_t surfaceNumber() const { return surfaceNumber_; }
  Renderer& renderer() { return *renderer_; }

  /// Milliseconds that a picture may take while something moves.
  double motionBudget = 24;
  /// Bytes that a better hierarchy may take while it is made.
  std::size_t refinementBudget = std::size_t{3} << 30;
  /// Surfaces that are bettered in place are asked whether they are closed: takes seconds for 10 M points,
  /// but for the interrupt.
  bool asksClosedness = true;
  /// Pixels may be twice as large while the view moves, where they take most of the time.
  bool mayCoarsenPixels = false;

 private:
  void replaceSurface(NewSurface&& fresh, const Progress* progress);
  void restate(Restate&& change);
  void recolor(const Recolor& change);
  void takeMesh(const PointSet& points, const std::vector<Rgba8>& colors, bool asMesh);
  bool isMoving(Clock::time_point now) const;
  bool drawsMesh() const;
  struct Pass {
    float tau;
    Accumulate accumulate = Accumulate::kStartAnew;
    bool isOneOfMany = false;
  };
  void draw(const Pass& pass, const View& view, const Progress* progress);
  bool drawCoarse();
  View drawnSize(const View& view, int coarseness) const;
  bool refinePicture(const Progress* interrupt);
  void leaveOutHidden();
  bool averagePicture(const Progress* interrupt);
  bool improvesInPlace() const;
  bool improveSurface(const Progress* interrupt);
  bool redrawTouched();
  void touchAll();
  void noteUnrefined(std::uint64_t surface, PointSet points, PointColors colors);

  std::unique_ptr<Renderer> renderer_;
  DisplayedSurface surface_;
  std::uint64_t surfaceNumber_ = 0, revision_ = 0, shownRevision_ = 0;
  PointSet meshPoints_;  // empty unless triangles are shown
  std::vector<Eigen::Vector3f> meshNormals_;
  std::vector<Rgba8> meshColors_;
  std::vector<Glyph> glyphs_;
  std::optional<View> view_;
  Appearance appearance_;
  RateControl rate_, coarseRate_;  // with plain and with coarse pixels
  CutMemory cutMemory_;
  Cut cut_;  // that was drawn last
  std::optional<Unrefined> unrefined_;
  // Colored otherwise since the colors that a better hierarchy will come with; none: too many to list.
  std::optional<std::vector<Index>> recolored_;
  std::vector<NodeRange> touched_;  // recolored since the last picture, where nothing else changed

  enum class Stage { kNothing, kStale, kCoarse, kConverged, kAveraged };
  Stage stage_ = Stage::kNothing;  // what the picture is
  int averaged_ = 0;
  Clock::time_point viewChanged_{}, sceneChanged_{};
  Index splats_ = 0;
  float tau_ = 0;
  double milliseconds_ = 0;
  View drawnView_;
  int coarseness_ = 1;  // of the picture
};

}  // namespace stipple
