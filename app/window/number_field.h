#pragma once

#include <QWidget>
#include <optional>

class QLineEdit;

namespace stipple {

/// A number with a unit: drag it sideways to change it, double click or Return to type it. Where both ends of
/// the range are known, a bar shows where in it the value is.
class NumberField final : public QWidget {
  Q_OBJECT

 public:
  struct Range {
    std::optional<double> min, max;
    bool isWhole = false;
    double typical = 1;  ///< the size of value that a drag is scaled to where the range is open
  };

  NumberField(const Range& range, const QString& unit, QWidget* parent = nullptr);

  double value() const { return value_; }
  /// Without a signal.
  void setValue(double value);
  QSize sizeHint() const override { return {120, 26}; }
  QSize minimumSizeHint() const override { return {70, 26}; }

 signals:
  void changed(double value);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  double clamped(double value) const;
  double shareOfRange() const;
  QString text() const;
  void change(double value);
  void beginTyping();
  void endTyping();

  Range range_;
  QString unit_;
  double value_ = 0, valueAtPress_ = 0;
  int pressX_ = 0;
  bool isDragging_ = false;
  QLineEdit* editor_;
};

}  // namespace stipple
