#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "app/view/frame_worker.h"
#include "app/window/viewport.h"

namespace stipple {

/// Shows the pictures of a frame worker that draws on the processor.
class CpuViewport final : public QWidget, public Viewport {
  Q_OBJECT

 public:
  explicit CpuViewport(QWidget* parent);

  QWidget& widget() override { return *this; }
  const char* backend() const override { return "cpu"; }
  void post(SceneChange change, std::uint64_t revision) override;
  void setView(const View& view) override;
  void setAppearance(const Appearance& appearance) override;
  std::optional<FrameNotes> notes() const override;
  std::optional<Picked> pickAt(const glm::vec2& px) override;
  std::vector<float> depthPicture() override;
  Image picture() override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void takePicture();
  void compose();
  void composeRow(int y, QRgb* row, int width) const;
  float depthAt(int x, int y) const;

  QImage composed_;
  std::shared_ptr<const Frame> frame_;
  Rgba8 background_ = *Appearance().background;
  std::unique_ptr<FrameWorker> worker_;  // last: it calls back into the rest
};

}  // namespace stipple
