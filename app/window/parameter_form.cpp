#include "app/window/parameter_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/window/icons.h"
#include "app/window/number_field.h"
#include "app/window/panel_wheel.h"
#include "core/error.h"

namespace stipple {

namespace {

QString unitText(Unit unit) {
  switch (unit) {
    case Unit::kAngle:
      return QStringLiteral("\u00b0");
    case Unit::kSpacingSquared:
      return QStringLiteral("h\u00b2");
    case Unit::kDiagonalSquared:
      return QStringLiteral("D\u00b2");
    default:
      return {};
  }
}

double asDouble(const ParameterValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return 0;
}

QString asText(const ParameterValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text ? QString::fromStdString(*text) : QString();
}

QString helpOf(const Parameter& parameter) {
  QString help = QString::fromStdString(parameter.help).toHtmlEscaped();
  return QString("<p><b>%1</b><br>%2</p>").arg(QString::fromStdString(parameter.title).toHtmlEscaped(), help);
}

}  // namespace

ParameterForm::ParameterForm(Parameters parameters, const std::vector<std::string>& attributes,
                             QWidget* parent)
    : QWidget(parent), parameters_(std::move(parameters)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(5);
  grid->setColumnStretch(1, 1);
  int row = 0;
  for (const Parameter& parameter : parameters_.declared()) {
    addRow(parameter, makeField(parameter, attributes), row++);
    for (const auto& refresh : refresh_[parameter.id]) refresh();
  }
}

void ParameterForm::set(const std::string& id, ParameterValue value) {
  try {
    parameters_.set(id, std::move(value));
  } catch (const InvalidInput&) {
    // Out of range: the field goes back to what holds.
  }
  for (const auto& refresh : refresh_[id]) refresh();
  emit changed();
}

void ParameterForm::addRow(const Parameter& parameter, QWidget* field, int row) {
  auto* grid = static_cast<QGridLayout*>(layout());
  auto* title = new QLabel(QString::fromStdString(parameter.title), this);
  auto* reset = new QToolButton(this);
  reset->setIcon(iconOf("reset"));
  reset->setIconSize({12, 12});
  reset->setToolTip(tr("Back to the default"));
  field->setObjectName(QString::fromStdString(parameter.id));
  for (QWidget* widget : {static_cast<QWidget*>(title), field}) widget->setToolTip(helpOf(parameter));
  grid->addWidget(title, row, 0);
  grid->addWidget(field, row, 1);
  grid->addWidget(reset, row, 2);
  const std::string id = parameter.id;
  const ParameterValue initial = parameter.defaultValue;
  connect(reset, &QToolButton::clicked, this, [this, id, initial] { set(id, initial); });
  refresh_[id].push_back([this, reset, id, initial] { reset->setVisible(parameters_.value(id) != initial); });
  QSizePolicy keeps = reset->sizePolicy();
  keeps.setRetainSizeWhenHidden(true);
  reset->setSizePolicy(keeps);
}

QWidget* ParameterForm::makeField(const Parameter& parameter, const std::vector<std::string>& attributes) {
  switch (parameter.type) {
    case ParameterType::kBool:
      return makeCheck(parameter);
    case ParameterType::kEnum:
    case ParameterType::kAttribute:
      return makeChoice(parameter, attributes);
    case ParameterType::kText:
      return makeText(parameter);
    default:
      return makeNumber(parameter);
  }
}

QWidget* ParameterForm::makeNumber(const Parameter& parameter) {
  const bool isWhole = parameter.type == ParameterType::kInt;
  const double typical = std::max(std::abs(asDouble(parameter.defaultValue)), isWhole ? 10.0 : 1e-3);
  auto* field =
      new NumberField({parameter.min, parameter.max, isWhole, typical}, unitText(parameter.unit), this);
  const std::string id = parameter.id;
  connect(field, &NumberField::changed, this, [this, id, isWhole](double value) {
    set(id, isWhole ? ParameterValue(std::int64_t{std::llround(value)}) : ParameterValue(value));
  });
  refresh_[id].push_back([this, field, id] { field->setValue(asDouble(parameters_.value(id))); });
  return field;
}

QWidget* ParameterForm::makeCheck(const Parameter& parameter) {
  auto* field = new QCheckBox(this);
  const std::string id = parameter.id;
  connect(field, &QCheckBox::clicked, this, [this, id](bool isOn) { set(id, isOn); });
  refresh_[id].push_back([this, field, id] { field->setChecked(parameters_.boolean(id)); });
  return field;
}

QWidget* ParameterForm::makeChoice(const Parameter& parameter, const std::vector<std::string>& attributes) {
  auto* field = new QComboBox(this);
  leaveWheelToPanel(field);
  field->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (const Choice& choice : parameter.choices)
    field->addItem(QString::fromStdString(choice.title), QString::fromStdString(choice.id));
  if (parameter.type == ParameterType::kAttribute) {
    if (asText(parameter.defaultValue).isEmpty()) field->insertItem(0, tr("none"), QString());
    for (const std::string& name : attributes) {
      const QString text = QString::fromStdString(name);
      if (field->findData(text) < 0) field->addItem(text, text);
    }
  }
  const std::string id = parameter.id;
  connect(field, &QComboBox::activated, this,
          [this, field, id](int index) { set(id, field->itemData(index).toString().toStdString()); });
  refresh_[id].push_back([this, field, id] {
    const QString value = asText(parameters_.value(id));
    if (field->findData(value) < 0) field->addItem(value, value);
    field->setCurrentIndex(field->findData(value));
  });
  return field;
}

QWidget* ParameterForm::makeText(const Parameter& parameter) {
  auto* field = new QLineEdit(this);
  const std::string id = parameter.id;
  connect(field, &QLineEdit::editingFinished, this,
          [this, field, id] { set(id, field->text().toStdString()); });
  refresh_[id].push_back([this, field, id] { field->setText(asText(parameters_.value(id))); });
  return field;
}

}  // namespace stipple
