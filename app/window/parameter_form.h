#pragma once

#include <QWidget>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "plugins/api/parameter.h"

namespace stipple {

/// Fields for the declared parameters of an operator: title, field with unit, reset; help as tool tip.
class ParameterForm final : public QWidget {
  Q_OBJECT

 public:
  /// `attributes`: names that parameters of type attribute offer beside their choices.
  ParameterForm(Parameters parameters, const std::vector<std::string>& attributes, QWidget* parent = nullptr);

  const Parameters& parameters() const { return parameters_; }

 signals:
  void changed();

 private:
  QWidget* makeField(const Parameter& parameter, const std::vector<std::string>& attributes);
  QWidget* makeNumber(const Parameter& parameter);
  QWidget* makeCheck(const Parameter& parameter);
  QWidget* makeChoice(const Parameter& parameter, const std::vector<std::string>& attributes);
  QWidget* makeText(const Parameter& parameter);
  void addRow(const Parameter& parameter, QWidget* field, int row);
  void set(const std::string& id, ParameterValue value);

  Parameters parameters_;
  // What puts the field of a parameter, and whether its reset is offered, in line with its value.
  std::map<std::string, std::vector<std::function<void()>>> refresh_;
};

}  // namespace stipple
