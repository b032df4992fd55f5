#pragma once

#include <QWidget>
#include <map>
#include <string>

#include "plugins/api/operator.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace stipple {

class ParameterForm;
class Workbench;

/// One operator at a time: its help, parameters, region and brushes, and the run.
class ProcessPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit ProcessPanel(Workbench& workbench, QWidget* parent = nullptr);

  void choose(const std::string& operatorId);
  std::string chosen() const;
  /// Sets a parameter of the chosen operator, as its field would.
  void setParameter(const std::string& id, const ParameterValue& value);
  /// The region of the chosen operator, from when there is such an attribute.
  void setRegion(const std::string& attribute);
  void start(bool paused = false);

 signals:
  void operatorChosen();
  void paintRequested(const PaintableInput& input);

 private:
  void buildRunRow(QVBoxLayout* column);
  void rebuild();
  void rebuildBrushes(const OperatorDescription& description);
  void refreshRegions(const OperatorDescription& description);
  void refreshRun();
  void parametersChanged();
  const OperatorDescription* description() const;
  std::vector<std::string> attributeNames() const;

  Workbench& workbench_;
  QComboBox *operators_, *region_;
  QLabel *help_, *regionTitle_, *progressText_;
  QWidget* brushes_;
  QVBoxLayout* formPlace_;
  ParameterForm* form_ = nullptr;
  QPushButton* run_;
  QToolButton *pause_, *step_, *stop_, *cancel_;
  QProgressBar* progress_;
  std::map<std::string, Parameters> kept_;  // what was set for operators chosen before
  std::string wantedRegion_;
  std::vector<std::string> shownAttributes_;
};

}  // namespace stipple
