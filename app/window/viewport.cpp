#include "app/window/viewport.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

#include "app/window/cpu_viewport.h"
#include "app/window/gl_viewport.h"
#include "render/gl/context.h"

namespace stipple {

namespace {

QSurfaceFormat neededFormat() {
  QSurfaceFormat format;
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

enum class Offer { kNone, kSoftware, kHardware };

// What a context of this desktop is.
Offer probeOpenGl() {
  QOffscreenSurface surface;
  surface.setFormat(neededFormat());
  surface.create();
  QOpenGLContext context;
  context.setFormat(neededFormat());
  if (!context.create() || !context.makeCurrent(&surface)) return Offer::kNone;
  const auto offered = gl::currentContext();
  context.doneCurrent();
  if (!offered || offered->version < 45) return Offer::kNone;
  return offered->isSoftware() ? Offer::kSoftware : Offer::kHardware;
}

}  // namespace

std::unique_ptr<Viewport> makeViewport(ViewportKind kind, QWidget* parent, std::string* complaint) {
  if (kind != ViewportKind::kCpu) {
    const Offer offer = probeOpenGl();
    if (offer == Offer::kHardware || (offer == Offer::kSoftware && kind == ViewportKind::kGl)) {
      QSurfaceFormat::setDefaultFormat(neededFormat());
      return std::make_unique<GlViewport>(parent);
    }
    if (kind == ViewportKind::kGl && complaint)
      *complaint = "OpenGL 4.5 is not to be had here, so the surface is drawn on the processor.";
  }
  return std::make_unique<CpuViewport>(parent);
}

}  // namespace stipple
