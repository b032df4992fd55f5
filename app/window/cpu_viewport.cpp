#include "app/window/cpu_viewport.h"

#include <QMetaObject>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/panels/imgui_raster.h"
#include "app/panels/overlay_context.h"

namespace stipple {

namespace {

// Pixels of a picture in the order that Qt's windows have.
void copyRow(const Rgba8* from, QRgb* to, int count) {
  for (int x = 0; x < count; ++x) to[x] = qRgb(from[x].r, from[x].g, from[x].b);
}

// The same, twice as wide, with means in between.
void widenRow(const Rgba8* from, QRgb* to, int count, int last) {
  for (int x = 0; x < count; x += 2) {
    const Rgba8 &a = from[x / 2], &b = from[std::min(x / 2 + 1, last)];
    to[x] = qRgb(a.r, a.g, a.b);
    if (x + 1 < count) to[x + 1] = qRgb((a.r + b.r) / 2, (a.g + b.g) / 2, (a.b + b.b) / 2);
  }
}

void averageRow(const QRgb* above, const QRgb* below, QRgb* to, int count) {
  for (int x = 0; x < count; ++x)
    to[x] = (above[x] & below[x]) + (((above[x] ^ below[x]) & 0xfefefefeu) >> 1);
}

}  // namespace

CpuViewport::CpuViewport(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_NoSystemBackground);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  worker_ = std::make_unique<FrameWorker>(makeRenderer(Backend::kCpu), [this] {
    QMetaObject::invokeMethod(this, &CpuViewport::takePicture, Qt::QueuedConnection);
  });
}

void CpuViewport::post(SceneChange change, std::uint64_t revision) {
  worker_->post(std::move(change), revision);
}

void CpuViewport::setView(const View& view) {
  worker_->setView(view);
}

void CpuViewport::setAppearance(const Appearance& appearance) {
  background_ = appearance.background.value_or(background_);
  worker_->setAppearance(appearance);
}

std::optional<FrameNotes> CpuViewport::notes() const {
  if (!frame_) return {};
  return static_cast<const FrameNotes&>(*frame_);
}

std::optional<Picked> CpuViewport::pickAt(const glm::vec2& px) {
  if (!frame_) return {};
  const View& view = frame_->view;
  const auto x = static_cast<int>(std::floor(px.x)), y = static_cast<int>(std::floor(px.y));
  if (x < 0 || y < 0 || x >= view.width || y >= view.height) return {};
  const float depth = depthAt(x, y);
  if (!std::isfinite(depth)) return {};
  return Picked{.position = view.toWorld(view.fromPixels(px, depth)), .depth = depth};
}

float CpuViewport::depthAt(int x, int y) const {
  const int fine = frame_->coarseness;
  return frame_->depth[static_cast<std::size_t>(y / fine) * frame_->image.width + x / fine];
}

std::vector<float> CpuViewport::depthPicture() {
  if (!frame_) return {};
  if (frame_->coarseness == 1) return frame_->depth;
  std::vector<float> depth;
  for (int y = 0; y < frame_->view.height; ++y) {
    for (int x = 0; x < frame_->view.width; ++x) depth.push_back(depthAt(x, y));
  }
  return depth;
}

Image CpuViewport::picture() {
  return frame_ ? frame_->image : Image();
}

void CpuViewport::takePicture() {
  if (auto sentence = worker_->takeFailure(); sentence && failed) failed(*sentence);
  frame_ = worker_->latest();
  update();
  if (frame_ && pictureChanged) pictureChanged();
}

// The picture at the widget's present size; one of another size stays in its corner until the next comes.
void CpuViewport::compose() {
  const QSize size = (QSizeF(this->size()) * devicePixelRatioF()).toSize();
  if (composed_.size() != size) composed_ = QImage(size, QImage::Format_RGB32);
  const QRgb empty = qRgb(background_.r, background_.g, background_.b);
  const int width = frame_ ? std::min(frame_->view.width, size.width()) : 0;
  const int height = frame_ ? std::min(frame_->view.height, size.height()) : 0;
  for (int y = 0; y < size.height(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(composed_.scanLine(y));
    if (y < height) composeRow(y, row, width);
    std::fill(row + (y < height ? width : 0), row + size.width(), empty);
  }
  if (frame_ && frame_->coarseness == 2) {
    for (int y = 1; y + 1 < height; y += 2) {
      const auto rowAt = [&](int at) { return reinterpret_cast<QRgb*>(composed_.scanLine(at)); };
      averageRow(rowAt(y - 1), rowAt(y + 1), rowAt(y), width);
    }
  }
}

void CpuViewport::composeRow(int y, QRgb* row, int width) const {
  const Image& image = frame_->image;
  const Rgba8* from = &image.pixels[static_cast<std::size_t>(y / frame_->coarseness) * image.width];
  if (frame_->coarseness == 1)
    copyRow(from, row, width);
  else
    widenRow(from, row, width, image.width - 1);
}

void CpuViewport::paintEvent(QPaintEvent*) {
  compose();
  if (overlay && overlayContext) {
    const ImDrawData& drawing = overlay();
    const std::size_t stride = static_cast<std::size_t>(composed_.bytesPerLine()) / sizeof(QRgb);
    auto* pixels = reinterpret_cast<std::uint32_t*>(composed_.bits());
    const PixelTarget target{.pixels = {pixels, stride * static_cast<std::size_t>(composed_.height())},
                             .width = composed_.width(),
                             .height = composed_.height(),
                             .stride = stride,
                             .order = ChannelOrder::kBgra};
    rasterize(drawing, overlayContext->atlas(), target);
  }
  composed_.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(this);
  painter.setCompositionMode(QPainter::CompositionMode_Source);
  painter.drawImage(0, 0, composed_);
}

}  // namespace stipple
