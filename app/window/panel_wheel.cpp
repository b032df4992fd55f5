#include "app/window/panel_wheel.h"

#include <QEvent>
#include <QWidget>

namespace stipple {

namespace {

class WheelFilter final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Wheel) return false;
    event->ignore();
    return true;
  }
};

}  // namespace

void leaveWheelToPanel(QWidget* field) {
  field->setFocusPolicy(Qt::StrongFocus);
  field->installEventFilter(new WheelFilter(field));
}

}  // namespace stipple
