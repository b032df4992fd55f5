#include "app/window/gl_viewport.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <QMetaObject>
#include <QOpenGLContext>
#include <QTimer>
#include <algorithm>
#include <chrono>

#include "app/panels/overlay_context.h"
#include "render/splat/gl_renderer.h"

namespace stipple {

namespace {

// The widget's context while it lives; within paintGL() it is current already and stays so.
class CurrentContext {
 public:
  explicit CurrentContext(QOpenGLWidget& widget)
      : widget_(widget), wasCurrent_(QOpenGLContext::currentContext() == widget.context()) {
    if (!wasCurrent_) widget_.makeCurrent();
  }
  ~CurrentContext() {
    if (!wasCurrent_) widget_.doneCurrent();
  }
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

 private:
  QOpenGLWidget& widget_;
  bool wasCurrent_;
};

}  // namespace

GlViewport::GlViewport(QWidget* parent) : QOpenGLWidget(parent), refiner_(requests_) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
}

GlViewport::~GlViewport() {
  refiner_.stop();
  releaseContext();
}

void GlViewport::releaseContext() {
  if (!maker_) return;
  const CurrentContext current(*this);
  if (hasOverlayRenderer_ && overlayContext) {
    overlayContext->makeCurrent();
    ImGui_ImplOpenGL3_Shutdown();
  }
  maker_.reset();
}

void GlViewport::post(SceneChange change, std::uint64_t revision) {
  requests_.post(std::move(change), revision);
  update();
}

void GlViewport::setView(const View& view) {
  requests_.setView(view);
  update();
}

void GlViewport::setAppearance(const Appearance& appearance) {
  requests_.setAppearance(appearance);
  update();
}

std::optional<FrameNotes> GlViewport::notes() const {
  return notes_;
}

std::optional<Picked> GlViewport::pickAt(const glm::vec2& px) {
  if (!maker_ || !notes_) return {};
  const CurrentContext current(*this);
  const auto pick = maker_->renderer().pick(static_cast<int>(px.x), static_cast<int>(px.y));
  if (!pick) return {};
  return Picked{.position = pick->position, .depth = pick->depth};
}

std::vector<float> GlViewport::depthPicture() {
  if (!maker_ || !notes_) return {};
  const CurrentContext current(*this);
  return maker_->renderer().depth();
}

Image GlViewport::picture() {
  if (!maker_ || !notes_) return {};
  const CurrentContext current(*this);
  return maker_->frame().image;
}

void GlViewport::initializeGL() {
  try {
    maker_ = std::make_unique<FrameMaker>(std::make_unique<GlRenderer>());
    maker_->asksClosedness = false;  // the window would stand still
  } catch (const Error& error) {
    if (failed) failed(error.what());
  }
}

void GlViewport::drawSurface() {
  try {
    requests_.applyTo(*maker_, nullptr);
    if (!maker_->step(nullptr)) return;
    notes_ = maker_->notes();
    if (pictureChanged)
      QMetaObject::invokeMethod(
          this, [this] { pictureChanged(); }, Qt::QueuedConnection);
  } catch (const std::exception& error) {
    if (failed) failed(error.what());
  }
}

void GlViewport::drawOverlay() {
  if (!overlay || !overlayContext) return;
  const ImDrawData& drawing = overlay();
  overlayContext->makeCurrent();
  if (!hasOverlayRenderer_) hasOverlayRenderer_ = ImGui_ImplOpenGL3_Init("#version 450 core");
  if (atlasRevision_ != overlayContext->atlasRevision()) {
    // Made anew, with all else that is missing, by the next call.
    ImGui_ImplOpenGL3_DestroyDeviceObjects();
    atlasRevision_ = overlayContext->atlasRevision();
  }
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplOpenGL3_RenderDrawData(const_cast<ImDrawData*>(&drawing));
}

void GlViewport::paintGL() {
  if (!maker_) return;
  drawSurface();
  static_cast<GlRenderer&>(maker_->renderer()).present();
  drawOverlay();
  scheduleNext();
}

// The next piece of work comes by itself, when it is due.
void GlViewport::scheduleNext() {
  if (auto waiting = maker_->takeUnrefined()) {
    refiner_.start(std::move(*waiting), [this] {
      QMetaObject::invokeMethod(
          this, [this] { update(); }, Qt::QueuedConnection);
    });
  }
  const auto due = maker_->nextDue();
  if (!due) return;
  using std::chrono::milliseconds;
  const auto wait = std::chrono::duration_cast<milliseconds>(*due - FrameMaker::Clock::now());
  QTimer::singleShot(std::max(milliseconds(0), wait), this, [this] { update(); });
}

}  // namespace stipple
