#include "app/window/histogram.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace stipple {

namespace {

constexpr int kBarHeight = 14, kTextHeight = 18, kGrip = 7;

}  // namespace

std::vector<std::size_t> countValues(const Attribute& attribute, double low, double high, int bins) {
  std::vector<std::size_t> counts(bins, 0);
  std::visit(
      [&]<class T>(const std::vector<T>& values) {
        if constexpr (std::is_arithmetic_v<T>) {
          const double scale = bins / (high - low);
          for (const T v : values) {
            const auto value = static_cast<double>(v);
            if (!(value >= low && value <= high)) continue;
            ++counts[std::min(bins - 1, static_cast<int>((value - low) * scale))];
          }
        }
      },
      attribute.column.values());
  return counts;
}

Histogram::Histogram(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(
      tr("Drag the ends of the bar to set the range of the colors. Drag over the bins to select points by "
         "value (Shift adds, Ctrl removes)."));
}

void Histogram::show(std::vector<std::size_t> counts, std::pair<double, double> full,
                     std::pair<double, double> range, Colormap colormap) {
  counts_ = std::move(counts);
  full_ = full;
  range_ = range;
  colormap_ = colormap;
  update();
}

QRect Histogram::binsRect() const {
  return rect().adjusted(4, 2, -4, -(kBarHeight + kTextHeight + 4));
}

QRect Histogram::barRect() const {
  return {4, height() - kBarHeight - kTextHeight, width() - 8, kBarHeight};
}

double Histogram::xOf(double value) const {
  const QRect bar = barRect();
  return bar.left() + (value - full_.first) / (full_.second - full_.first) * bar.width();
}

double Histogram::valueAt(double x) const {
  const QRect bar = barRect();
  const double share = std::clamp((x - bar.left()) / std::max(1, bar.width()), 0.0, 1.0);
  return full_.first + share * (full_.second - full_.first);
}

void Histogram::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (counts_.empty()) return;
  paintBins(painter);
  paintBar(painter);
}

void Histogram::paintBins(QPainter& painter) const {
  const QRect box = binsRect();
  // Roots, so that small counts are seen beside large ones.
  const double most = std::sqrt(static_cast<double>(*std::ranges::max_element(counts_)));
  const double step = static_cast<double>(box.width()) / static_cast<double>(counts_.size());
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::PlaceholderText));
  for (std::size_t bin = 0; bin < counts_.size() && most > 0; ++bin) {
    const double tall = box.height() * std::sqrt(static_cast<double>(counts_[bin])) / most;
    painter.drawRect(
        QRectF(box.left() + step * static_cast<double>(bin), box.bottom() + 1 - tall, step, tall));
  }
  if (grip_ != Grip::kMark) return;
  QColor mark = palette().color(QPalette::Highlight);
  mark.setAlpha(110);
  const double from = xOf(std::min(marked_.first, marked_.second)),
               to = xOf(std::max(marked_.first, marked_.second));
  painter.fillRect(QRectF(from, box.top(), to - from, box.height()), mark);
}

void Histogram::paintBar(QPainter& painter) const {
  const QRect bar = barRect();
  for (int x = bar.left(); x <= bar.right(); ++x) {
    const Rgba8 color = mapColor(colormap_, (valueAt(x) - range_.first) / (range_.second - range_.first));
    painter.fillRect(x, bar.top(), 1, bar.height(), QColor(color.r, color.g, color.b));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Window), 1));
  painter.setBrush(palette().color(QPalette::WindowText));
  for (const double end : {range_.first, range_.second}) {
    const double x = std::clamp(xOf(end), double(bar.left()), double(bar.right()));
    painter.drawRoundedRect(QRectF(x - 3, bar.top() - 2, 6, bar.height() + 4), 2, 2);
  }
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const QRect text(bar.left(), bar.bottom() + 3, bar.width(), kTextHeight);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignTop, QString::number(range_.first, 'g', 4));
  painter.drawText(text, Qt::AlignRight | Qt::AlignTop, QString::number(range_.second, 'g', 4));
}

void Histogram::mousePressEvent(QMouseEvent* event) {
  if (counts_.empty() || event->button() != Qt::LeftButton) return;
  const double x = event->position().x();
  if (event->position().y() >= barRect().top() - 3) {
    const double toLow = std::abs(x - xOf(range_.first)), toHigh = std::abs(x - xOf(range_.second));
    if (std::min(toLow, toHigh) <= kGrip) grip_ = toLow < toHigh ? Grip::kLow : Grip::kHigh;
    return;
  }
  grip_ = Grip::kMark;
  marked_ = {valueAt(x), valueAt(x)};
}

void Histogram::mouseMoveEvent(QMouseEvent* event) {
  if (grip_ == Grip::kNone) return;
  const double value = valueAt(event->position().x());
  if (grip_ == Grip::kMark) marked_.second = value;
  if (grip_ == Grip::kLow && value < range_.second) range_.first = value;
  if (grip_ == Grip::kHigh && value > range_.first) range_.second = value;
  if (grip_ != Grip::kMark) emit rangeChanged(range_.first, range_.second);
  update();
}

void Histogram::mouseReleaseEvent(QMouseEvent*) {
  const Grip grip = std::exchange(grip_, Grip::kNone);
  if (grip == Grip::kMark)
    emit valuesMarked(std::min(marked_.first, marked_.second), std::max(marked_.first, marked_.second));
  update();
}

}  // namespace stipple
