#pragma once

#include <QOpenGLWidget>
#include <memory>

#include "app/view/frame_requests.h"
#include "app/view/surface_refiner.h"
#include "app/window/viewport.h"

namespace stipple {

/// Draws with OpenGL, straight into the window.
class GlViewport final : public QOpenGLWidget, public Viewport {
  Q_OBJECT

 public:
  explicit GlViewport(QWidget* parent);
  ~GlViewport() override;

  QWidget& widget() override { return *this; }
  const char* backend() const override { return "gl"; }
  void post(SceneChange change, std::uint64_t revision) override;
  void setView(const View& view) override;
  void setAppearance(const Appearance& appearance) override;
  std::optional<FrameNotes> notes() const override;
  std::optional<Picked> pickAt(const glm::vec2& px) override;
  std::vector<float> depthPicture() override;
  Image picture() override;

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  void drawSurface();
  void drawOverlay();
  void scheduleNext();
  void releaseContext();

  FrameRequests requests_;
  SurfaceRefiner refiner_;
  std::unique_ptr<FrameMaker> maker_;
  std::optional<FrameNotes> notes_;
  std::uint64_t atlasRevision_ = 0;
  bool hasOverlayRenderer_ = false;
};

}  // namespace stipple
