#include "app/window/number_field.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace stipple {

namespace {

constexpr int kDragThreshold = 3;    // pixels before a press becomes a drag
constexpr double kDragLength = 240;  // pixels from one end of a range to the other

}  // namespace

NumberField::NumberField(const Range& range, const QString& unit, QWidget* parent)
    : QWidget(parent), range_(range), unit_(unit), editor_(new QLineEdit(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeHorCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  editor_->hide();
  connect(editor_, &QLineEdit::editingFinished, this, &NumberField::endTyping);
}

void NumberField::setValue(double value) {
  value_ = clamped(value);
  update();
}

double NumberField::clamped(double value) const {
  if (range_.isWhole) value = std::round(value);
  if (range_.min) value = std::max(value, *range_.min);
  if (range_.max) value = std::min(value, *range_.max);
  return value;
}

double NumberField::shareOfRange() const {
  if (!range_.min || !range_.max || *range_.max <= *range_.min) return 0;
  return (value_ - *range_.min) / (*range_.max - *range_.min);
}

QString NumberField::text() const {
  const QString number =
      range_.isWhole ? QString::number(std::llround(value_)) : QString::number(value_, 'g', 5);
  return unit_.isEmpty() ? number : number + ' ' + unit_;
}

void NumberField::change(double value) {
  const double next = clamped(value);
  if (next == value_) return;
  value_ = next;
  update();
  emit changed(value_);
}

void NumberField::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(QPen(hasFocus() ? palette().color(QPalette::Highlight) : palette().color(QPalette::Mid), 1));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRoundedRect(box, 5, 5);
  if (const double share = shareOfRange(); share > 0 && isEnabled()) {
    QColor bar = palette().color(QPalette::Highlight);
    bar.setAlpha(90);
    painter.setPen(Qt::NoPen);
    painter.setBrush(bar);
    painter.setClipRect(QRectF(0, 0, width() * std::min(1.0, share), height()));
    painter.drawRoundedRect(box, 5, 5);
    painter.setClipping(false);
  }
  painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Text));
  painter.drawText(rect().adjusted(8, 0, -8, 0), Qt::AlignVCenter | Qt::AlignRight, text());
}

void NumberField::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressX_ = event->position().toPoint().x();
  valueAtPress_ = value_;
  isDragging_ = false;
}

void NumberField::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return;
  const int moved = event->position().toPoint().x() - pressX_;
  if (!isDragging_ && std::abs(moved) < kDragThreshold) return;
  isDragging_ = true;
  const bool isClosed = range_.min && range_.max;
  double perPixel =
      (isClosed ? *range_.max - *range_.min : 2 * std::max(std::abs(valueAtPress_), range_.typical)) /
      kDragLength;
  if (event->modifiers() & Qt::ShiftModifier) perPixel /= 10;
  change(valueAtPress_ + moved * perPixel);
}

void NumberField::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !isDragging_) setFocus();
  isDragging_ = false;
}

void NumberField::mouseDoubleClickEvent(QMouseEvent*) {
  beginTyping();
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  const double step = range_.isWhole ? 1 : std::max(std::abs(value_), range_.typical) / 50;
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return beginTyping();
    case Qt::Key_Up:
      return change(value_ + step);
    case Qt::Key_Down:
      return change(value_ - step);
    default:
      QWidget::keyPressEvent(event);
  }
}

void NumberField::resizeEvent(QResizeEvent*) {
  editor_->setGeometry(rect());
}

void NumberField::beginTyping() {
  editor_->setText(range_.isWhole ? QString::number(std::llround(value_)) : QString::number(value_, 'g', 9));
  editor_->show();
  editor_->setFocus();
  editor_->selectAll();
}

void NumberField::endTyping() {
  if (!editor_->isVisible()) return;
  editor_->hide();
  bool isNumber = false;
  const double typed = QLocale::c().toDouble(editor_->text().trimmed(), &isNumber);
  if (isNumber && std::isfinite(typed)) change(typed);
}

}  // namespace stipple
