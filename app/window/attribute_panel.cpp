#include "app/window/attribute_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/window/histogram.h"
#include "app/window/icons.h"
#include "app/window/panel_wheel.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

constexpr int kBins = 64;

bool isScalar(const Attribute& attribute) {
  return attribute.type() != AttributeType::kColor && attribute.type() != AttributeType::kVector3;
}

QString colormapTitle(const std::string& name) {
  QString title = QString::fromStdString(name).replace('-', ' ');
  title[0] = title[0].toUpper();
  return title;
}

}  // namespace

AttributePanel::AttributePanel(Workbench& workbench, QWidget* parent)
    : QWidget(parent),
      workbench_(workbench),
      list_(new QTreeWidget(this)),
      colors_(new QWidget(this)),
      colormap_(new QComboBox(this)),
      saturation_(new QComboBox(this)),
      wholeRange_(new QPushButton(tr("Whole range"), this)),
      histogram_(new Histogram(this)),
      summary_(new QLabel(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 6, 10, 10);
  column->setSpacing(8);
  buildList();
  column->addWidget(list_);
  buildColors();
  column->addWidget(colors_);
  column->addStretch(1);
  connect(&workbench, &Workbench::pointsChanged, this, &AttributePanel::refresh);
  connect(&workbench, &Workbench::currentChanged, this, &AttributePanel::refresh);
  refresh();
}

void AttributePanel::buildList() {
  list_->setObjectName("attributes");
  list_->setColumnCount(4);
  list_->setHeaderHidden(true);
  list_->setRootIsDecorated(false);
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  list_->setFixedHeight(132);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (const int section : {1, 2, 3})
    list_->header()->setSectionResizeMode(section, QHeaderView::ResizeToContents);
  connect(list_, &QTreeWidget::itemClicked, this,
          [this](QTreeWidgetItem* item) { show(item->data(0, Qt::UserRole).toString().toStdString()); });
}

void AttributePanel::buildColors() {
  auto* column = new QVBoxLayout(colors_);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  leaveWheelToPanel(colormap_);
  leaveWheelToPanel(saturation_);
  int index = 0;
  for (const std::string& name : colormapNames()) colormap_->addItem(colormapTitle(name), index++);
  colormap_->setToolTip(tr("How numbers become colors"));
  row->addWidget(colormap_, 1);
  row->addWidget(wholeRange_);
  column->addLayout(row);
  column->addWidget(histogram_);
  summary_->setProperty("faint", true);
  column->addWidget(summary_);
  auto* fade = new QHBoxLayout;
  auto* title = new QLabel(tr("Saturation by"), colors_);
  saturation_->setToolTip(tr("Colors fade to gray where this attribute is low"));
  fade->addWidget(title);
  fade->addWidget(saturation_, 1);
  column->addLayout(fade);
  const auto relook = [this](auto&& change) {
    if (OpenScan* scan = workbench_.current()) {
      change(scan->look);
      emit lookChanged();
      refresh();
    }
  };
  connect(colormap_, &QComboBox::activated, this, [relook](int map) {
    relook([map](Look& look) { look.colors.colormap = static_cast<Colormap>(map); });
  });
  connect(wholeRange_, &QPushButton::clicked, this,
          [relook] { relook([](Look& look) { look.colors.range.reset(); }); });
  connect(histogram_, &Histogram::rangeChanged, this, [this](double low, double high) {
    if (OpenScan* scan = workbench_.current()) {
      scan->look.colors.range = {low, high};
      emit lookChanged();
    }
  });
  connect(histogram_, &Histogram::valuesMarked, this, [this](double low, double high) {
    if (const OpenScan* scan = workbench_.current())
      emit valuesMarked(scan->look.colors.attribute, low, high);
  });
  connect(saturation_, &QComboBox::activated, this, [this, relook](int at) {
    const std::string name = saturation_->itemData(at).toString().toStdString();
    relook([&name](Look& look) { look.colors.saturationBy = name; });
  });
}

void AttributePanel::refresh() {
  refreshList();
  refreshColors();
}

void AttributePanel::refreshList() {
  list_->clear();
  const OpenScan* scan = workbench_.current();
  if (!scan) return;
  const std::string& shown = scan->look.colors.attribute;
  const auto add = [&](const QString& name, const QString& type, const std::string& id) {
    auto* item = new QTreeWidgetItem(list_, {name, type});
    item->setData(0, Qt::UserRole, QString::fromStdString(id));
    item->setForeground(1, palette().color(QPalette::PlaceholderText));
    item->setIcon(2, iconOf(shown == id ? "eye" : "eye_off"));
    item->setToolTip(2, tr("Show this attribute"));
    return item;
  };
  const bool hasColor = scan->document.points().has("color");
  add(hasColor ? tr("color") : tr("plain"), hasColor ? "color" : "", "");
  for (const Attribute& attribute : scan->document.points().attributes()) {
    if (attribute.name == "color" && attribute.type() == AttributeType::kColor) continue;
    QTreeWidgetItem* item =
        add(QString::fromStdString(attribute.name), nameOf(attribute.type()), attribute.name);
    auto* button = new QToolButton(list_);
    button->setIcon(iconOf("close"));
    button->setIconSize({11, 11});
    button->setToolTip(tr("Remove this attribute (can be undone)"));
    connect(button, &QToolButton::clicked, this, [this, name = attribute.name] { remove(name); });
    list_->setItemWidget(item, 3, button);
  }
}

void AttributePanel::refreshColors() {
  const OpenScan* scan = workbench_.current();
  const PointColors colors = scan ? scan->follower.colors() : PointColors();
  const bool areNumbers = colors.kind() == PointColors::Kind::kNumbers;
  const std::string& name = colors.source().attribute;
  const Attribute* attribute = scan ? scan->document.points().find(name) : nullptr;
  colors_->setVisible(attribute && isScalar(*attribute));
  if (!attribute || !isScalar(*attribute)) return;
  histogram_->setVisible(areNumbers);
  wholeRange_->setVisible(areNumbers && scan->look.colors.range.has_value());
  const auto full = rangeOf(scan->document.points(), name);
  colormap_->setCurrentIndex(static_cast<int>(colors.colormap()));
  if (areNumbers)
    histogram_->show(countValues(*attribute, full.first, full.second, kBins), full, colors.range(),
                     colors.colormap());
  summary_->setText(areNumbers ? tr("from %1 to %2").arg(full.first, 0, 'g', 5).arg(full.second, 0, 'g', 5)
                               : tr("labels up to %1").arg(full.second, 0, 'f', 0));
  const QSignalBlocker quiet(saturation_);
  saturation_->clear();
  saturation_->addItem(tr("nothing"), QString());
  for (const Attribute& other : scan->document.points().attributes()) {
    if (isScalar(other))
      saturation_->addItem(QString::fromStdString(other.name), QString::fromStdString(other.name));
  }
  saturation_->setCurrentIndex(
      std::max(0, saturation_->findData(QString::fromStdString(scan->look.colors.saturationBy))));
}

void AttributePanel::show(const std::string& attribute) {
  OpenScan* scan = workbench_.current();
  if (!scan || scan->look.colors.attribute == attribute) return;
  scan->look.colors = ColorSource{.attribute = attribute};
  emit lookChanged();
  refresh();
}

void AttributePanel::remove(const std::string& attribute) {
  const OpenScan* scan = workbench_.current();
  if (!scan) return;
  PointSet after = scan->document.points();
  after.erase(attribute);
  workbench_.commit(tr("Remove %1").arg(QString::fromStdString(attribute)).toStdString(), after);
}

}  // namespace stipple
