#pragma once

#include <QWidget>
#include <optional>
#include <utility>
#include <vector>

#include "core/points/point_set.h"
#include "render/appearance/colormap.h"

namespace stipple {

/// Counts of the finite values of a scalar attribute in equal bins of [low, high].
std::vector<std::size_t> countValues(const Attribute& attribute, double low, double high, int bins);

/// Histogram of a scalar attribute over its colormap. Dragging the ends of the bar sets the range; a drag
/// over the bins marks values.
class Histogram final : public QWidget {
  Q_OBJECT

 public:
  explicit Histogram(QWidget* parent = nullptr);

  void show(std::vector<std::size_t> counts, std::pair<double, double> full, std::pair<double, double> range,
            Colormap colormap);
  QSize sizeHint() const override { return {220, 96}; }
  QSize minimumSizeHint() const override { return {120, 80}; }

 signals:
  void rangeChanged(double low, double high);
  void valuesMarked(double low, double high);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  enum class Grip { kNone, kLow, kHigh, kMark };

  double valueAt(double x) const;
  double xOf(double value) const;
  QRect binsRect() const;
  QRect barRect() const;
  void paintBins(QPainter& painter) const;
  void paintBar(QPainter& painter) const;

  std::vector<std::size_t> counts_;
  std::pair<double, double> full_{0, 1}, range_{0, 1}, marked_{0, 0};
  Colormap colormap_ = Colormap::kViridis;
  Grip grip_ = Grip::kNone;
};

}  // namespace stipple
