#include "app/window/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

namespace stipple {

namespace {

QPixmap draw(QByteArray svg, const QColor& color, int size) {
  svg.replace("#000", color.name().toLatin1());
  QSvgRenderer renderer(svg);
  QPixmap pixmap(size, size);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  renderer.render(&painter);
  return pixmap;
}

}  // namespace

QIcon iconOf(const char* name) {
  QFile file(QString(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray svg = file.readAll();
  const QPalette palette = QGuiApplication::palette();
  const QColor plain = palette.color(QPalette::WindowText);
  const QColor faint = palette.color(QPalette::Disabled, QPalette::WindowText);
  QIcon icon;
  for (const int size : {16, 20, 24, 32, 40, 48, 64}) {
    icon.addPixmap(draw(svg, plain, size), QIcon::Normal, QIcon::Off);
    icon.addPixmap(draw(svg, QColor(26, 26, 26), size), QIcon::Normal, QIcon::On);
    icon.addPixmap(draw(svg, faint, size), QIcon::Disabled, QIcon::Off);
  }
  return icon;
}

}  // namespace stipple
