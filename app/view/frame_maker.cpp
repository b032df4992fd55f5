#include "app/view/frame_maker.h"

#include <algorithm>

#include "render/hierarchy/hidden_nodes.h"
#include "render/hierarchy/jitter.h"
#include "render/hierarchy/splat_radii.h"

namespace stipple {

namespace {

using namespace std::chrono_literals;

// The view is at rest when it has not changed for so long; the brush when nothing was painted.
constexpr auto kViewRest = 120ms;
constexpr auto kSceneRest = 250ms;
constexpr int kAveragedFrames = 16;
// Triangles that are drawn while the view moves; more of them are shown as splats meanwhile.
constexpr std::size_t kMovingTriangles = 300'000;
constexpr Rgba8 kGlyphColor{222, 56, 32, 255};

bool sameView(const View& a, const View& b) {
  return a.eye == b.eye && a.viewFromWorld == b.viewFromWorld && a.projection == b.projection &&
         a.focalPx == b.focalPx && a.width == b.width && a.height == b.height;
}

}  // namespace

FrameMaker::FrameMaker(std::unique_ptr<Renderer> renderer) : renderer_(std::move(renderer)) {}
FrameMaker::~FrameMaker() = default;

void FrameMaker::apply(SceneChange change, std::uint64_t revision, const Progress* progress) {
  revision_ = std::max(revision_, revision);
  sceneChanged_ = Clock::now();
  if (auto* fresh = std::get_if<NewSurface>(&change)) {
    replaceSurface(std::move(*fresh), progress);
  } else if (auto* restated = std::get_if<Restate>(&change)) {
    restate(std::move(*restated));
  } else if (const auto* recolored = std::get_if<Recolor>(&change)) {
    recolor(*recolored);
  } else if (auto* refined = std::get_if<Refined>(&change)) {
    if (refined->surface != surfaceNumber_ || refined->hierarchy.leafCount() != surface_.size()) return;
    surface_.adopt(std::move(refined->hierarchy), recolored_);
    cutMemory_ = {};
    renderer_->upload(surface_.hierarchy(), {{.begin = 0, .end = surface_.hierarchy().nodeCount()}});
    touchAll();
  }
}

void FrameMaker::replaceSurface(NewSurface&& fresh, const Progress* progress) {
  const std::vector<Rgba8> colors = fresh.colors.of(fresh.points);
  surface_ = {};  // its memory goes before the next one's comes
  surface_ = DisplayedSurface(fresh.points, colors, progress);
  surfaceNumber_ = fresh.surface;
  cutMemory_ = {};
  glyphs_ =
      fresh.glyphs.empty() ? std::vector<Glyph>{} : makeGlyphs(fresh.points, fresh.glyphs, {}, progress);
  takeMesh(fresh.points, colors, fresh.asMesh);
  noteUnrefined(fresh.surface, std::move(fresh.points), std::move(fresh.colors));
  renderer_->upload(surface_.hierarchy(), {{.begin = 0, .end = surface_.hierarchy().nodeCount()}});
  touchAll();
}

void FrameMaker::restate(Restate&& change) {
  if (change.points.size() != surface_.size()) return;
  const std::vector<Rgba8> colors = change.colors.of(change.points);
  std::vector<NodeRange> changed = surface_.recolorAll(colors);
  if (change.moved) changed = surface_.move(change.points);
  surfaceNumber_ = change.surface;
  glyphs_ =
      change.glyphs.empty() ? std::vector<Glyph>{} : makeGlyphs(change.points, change.glyphs, {}, nullptr);
  takeMesh(change.points, colors, change.asMesh);
  recolored_.reset();
  if (change.moved || unrefined_) {
    noteUnrefined(change.surface, std::move(change.points), std::move(change.colors));
  }
  renderer_->upload(surface_.hierarchy(), changed);
  touchAll();
}

void FrameMaker::recolor(const Recolor& change) {
  const std::vector<NodeRange> changed = surface_.recolor(change.rows, change.colors);
  if (recolored_) recolored_->insert(recolored_->end(), change.rows.begin(), change.rows.end());
  if (recolored_ && recolored_->size() > surface_.size()) recolored_.reset();
  renderer_->upload(surface_.hierarchy(), changed);
  if (meshPoints_.size() > 0) {
    for (std::size_t i = 0; i < change.rows.size(); ++i) meshColors_[change.rows[i]] = change.colors[i];
    return touchAll();
  }
  if (stage_ == Stage::kStale || stage_ == Stage::kNothing) return;
  touched_.insert(touched_.end(), changed.begin(), changed.end());
}

void FrameMaker::noteUnrefined(std::uint64_t surface, PointSet points, PointColors colors) {
  unrefined_ = Unrefined{.surface = surface, .points = std::move(points), .colors = std::move(colors)};
  recolored_.emplace();
}

void FrameMaker::takeMesh(const PointSet& points, const std::vector<Rgba8>& colors, bool asMesh) {
  const bool shows = asMesh && !points.triangles().empty();
  meshPoints_ = shows ? points : PointSet();
  meshColors_ = shows ? colors : std::vector<Rgba8>();
  meshNormals_ = shows ? normalsOfFile(points) : std::vector<Eigen::Vector3f>();
}

void FrameMaker::touchAll() {
  touched_.clear();
  stage_ = Stage::kStale;
}

void FrameMaker::setView(const View& view) {
  if (view_ && sameView(*view_, view)) return;
  view_ = view;
  viewChanged_ = Clock::now();
  touchAll();
}

void FrameMaker::setAppearance(const Appearance& appearance) {
  appearance_ = appearance;
  touchAll();
}

bool FrameMaker::isMoving(Clock::time_point now) const {
  return now - viewChanged_ < kViewRest;
}

bool FrameMaker::drawsMesh() const {
  return meshPoints_.size() > 0 &&
         (meshPoints_.triangles().size() <= kMovingTriangles || !isMoving(Clock::now()));
}

bool FrameMaker::step(const Progress* interrupt) {
  if (!view_ || surface_.size() == 0 || view_->width <= 0 || view_->height <= 0) return false;
  const auto now = Clock::now();
  if (stage_ == Stage::kNothing || stage_ == Stage::kStale) return drawCoarse();
  if (!touched_.empty()) return redrawTouched();
  if (const auto due = nextDue(); !due || now < *due) return false;
  try {
    if (stage_ == Stage::kAveraged) return improveSurface(interrupt);
    return stage_ == Stage::kCoarse ? refinePicture(interrupt) : averagePicture(interrupt);
  } catch (const Cancelled&) {
    return false;
  }
}

std::optional<FrameMaker::Clock::time_point> FrameMaker::nextDue() const {
  if (!view_ || surface_.size() == 0 || stage_ == Stage::kNothing) return {};
  if (stage_ == Stage::kStale || !touched_.empty()) return Clock::now();
  if (stage_ == Stage::kCoarse) return viewChanged_ + kViewRest;
  if (stage_ == Stage::kConverged) return std::max(viewChanged_ + kViewRest, sceneChanged_ + kSceneRest);
  if (improvesInPlace()) return std::max(viewChanged_ + kViewRest, sceneChanged_ + kSceneRest);
  return {};
}

void FrameMaker::draw(const Pass& pass, const View& view, const Progress* progress) {
  const auto begin = Clock::now();
  Appearance appearance = appearance_;
  appearance.isOneOfMany = pass.isOneOfMany;
  if (drawsMesh()) {
    const SurfaceMesh mesh{meshPoints_.positions(), meshNormals_, meshColors_, meshPoints_.triangles()};
    renderer_->drawMesh(mesh, view, appearance, pass.accumulate, progress);
    splats_ = 0;
    tau_ = RateControl::kFinest;
  } else {
    // Frames of a mean share the cut of the first.
    if (pass.accumulate == Accumulate::kStartAnew)
      cut_ = selectCut(surface_.hierarchy(), view, {.tau = pass.tau}, &cutMemory_, progress);
    renderer_->draw(surface_.hierarchy(), cut_.nodes, view, appearance, pass.accumulate, progress);
    splats_ = static_cast<Index>(cut_.nodes.size());
    tau_ = cut_.tau;
  }
  milliseconds_ = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  drawnView_ = view;
  touched_.clear();
  shownRevision_ = revision_;
}

View FrameMaker::drawnSize(const View& view, int coarseness) const {
  View drawn = view;
  drawn.width = (view.width + coarseness - 1) / coarseness;
  drawn.height = (view.height + coarseness - 1) / coarseness;
  drawn.focalPx = view.focalPx / static_cast<float>(coarseness);
  // The same center, where sizes are odd.
  drawn.jitterPx = view.centerPx() / static_cast<float>(coarseness) -
                   0.5f * glm::vec2(static_cast<float>(drawn.width), static_cast<float>(drawn.height));
  return drawn;
}

// What must be seen at once: as fine as the time allows.
bool FrameMaker::drawCoarse() {
  // Most of the time may go to splats, not to pixels.
  constexpr double kMostForPixels = 0.6;
  const bool coarsens = mayCoarsenPixels && isMoving(Clock::now()) && glyphs_.empty() &&
                        rate_.pictureCost() > kMostForPixels * motionBudget;
  coarseness_ = coarsens ? 2 : 1;
  RateControl& rate = coarsens ? coarseRate_ : rate_;
  const float tau = std::max(rate.tauFor(motionBudget), RateControl::kFinest);
  draw({.tau = tau}, drawnSize(*view_, coarseness_), nullptr);
  rate.drew(splats_, tau_, milliseconds_);
  const bool isFinest = tau_ <= RateControl::kFinest && coarseness_ == 1;
  stage_ = isFinest ? Stage::kConverged : Stage::kCoarse;
  averaged_ = 0;
  return true;
}

bool FrameMaker::refinePicture(const Progress* interrupt) {
  draw({.tau = RateControl::kFinest}, *view_, interrupt);
  coarseness_ = 1;
  stage_ = Stage::kConverged;
  averaged_ = 0;
  return true;
}

// Of the cut that was drawn last.
void FrameMaker::leaveOutHidden() {
  if (splats_ == 0) return;  // triangles
  cut_.nodes = withoutHidden(surface_.hierarchy(), cut_.nodes, drawnView_, renderer_->depth());
  splats_ = static_cast<Index>(cut_.nodes.size());
}

// Only the mean of all frames is shown: on the way to it the picture rests.
bool FrameMaker::averagePicture(const Progress* interrupt) {
  View view = *view_;
  view.jitterPx = jitterOfFrame(averaged_);
  if (averaged_ == 0) {
    leaveOutHidden();
    draw({.tau = tauOfMean(tau_, splats_), .isOneOfMany = true}, view, interrupt);
    leaveOutHidden();
  } else {
    draw({.tau = tau_, .accumulate = Accumulate::kAddToMean, .isOneOfMany = true}, view, interrupt);
  }
  if (++averaged_ < kAveragedFrames) return false;
  stage_ = Stage::kAveraged;
  return true;
}

bool FrameMaker::improvesInPlace() const {
  return unrefined_ && unrefined_->points.size() * kRefinementBytes > refinementBudget;
}

// The picture stays until all is done.
bool FrameMaker::improveSurface(const Progress* interrupt) {
  if (!surface_.isSorted()) {
    renderer_->upload(surface_.hierarchy(), surface_.sortNext());
    return false;
  }
  if (asksClosedness) surface_.askClosedness(unrefined_->points, interrupt);
  unrefined_.reset();
  cutMemory_ = {};
  touchAll();
  return false;
}

bool FrameMaker::redrawTouched() {
  const auto begin = Clock::now();
  std::ranges::sort(touched_, {}, &NodeRange::begin);
  std::vector<NodeRange> ranges;
  for (const NodeRange& range : touched_) {
    if (!ranges.empty() && range.begin <= ranges.back().end)
      ranges.back().end = std::max(ranges.back().end, range.end);
    else
      ranges.push_back(range);
  }
  renderer_->redraw(surface_.hierarchy(), ranges);
  touched_.clear();
  milliseconds_ = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  shownRevision_ = revision_;
  if (stage_ == Stage::kAveraged) stage_ = Stage::kConverged;
  averaged_ = 0;
  return true;
}

std::optional<Unrefined> FrameMaker::takeUnrefined() {
  const bool isCalm = Clock::now() - sceneChanged_ >= kSceneRest;
  if (!isCalm || improvesInPlace() || (stage_ != Stage::kConverged && stage_ != Stage::kAveraged)) return {};
  return std::exchange(unrefined_, std::nullopt);
}

FrameNotes FrameMaker::notes() const {
  FrameNotes notes{.view = view_.value_or(View()),
                   .coarseness = coarseness_,
                   .splats = splats_,
                   .tau = tau_,
                   .milliseconds = milliseconds_,
                   .isConverged = stage_ == Stage::kConverged || stage_ == Stage::kAveraged,
                   .averaged = stage_ == Stage::kAveraged ? kAveragedFrames : 1,
                   .surface = surfaceNumber_,
                   .revision = shownRevision_};
  return notes;
}

Frame FrameMaker::frame() {
  Frame frame{notes(), renderer_->image(), renderer_->depth()};
  if (!glyphs_.empty()) drawGlyphs(frame.image, frame.depth, drawnView_, glyphs_, kGlyphColor);
  return frame;
}

}  // namespace stipple
