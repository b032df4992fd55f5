#pragma once

#include <QWidget>
#include <string>

class QComboBox;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;
class QPushButton;

namespace stipple {

class Histogram;
class Workbench;

/// The attributes of the current scan: which one is shown, with what colormap and range; removing and
/// renaming; histogram.
class AttributePanel final : public QWidget {
  Q_OBJECT

 public:
  explicit AttributePanel(Workbench& workbench, QWidget* parent = nullptr);

 signals:
  /// The look of the current scan is another one.
  void lookChanged();
  void valuesMarked(const std::string& attribute, double low, double high);

 private:
  void buildList();
  void buildColors();
  void refresh();
  void refreshList();
  void refreshColors();
  void show(const std::string& attribute);
  void remove(const std::string& attribute);

  Workbench& workbench_;
  QTreeWidget* list_;
  QWidget* colors_;
  QComboBox *colormap_, *saturation_;
  QPushButton* wholeRange_;
  Histogram* histogram_;
  QLabel* summary_;
};

}  // namespace stipple
