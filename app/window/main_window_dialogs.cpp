// What the main window asks the user, and files that it reads and writes for them.
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QImage>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSaveFile>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/document/recipe.h"
#include "app/tools/selection.h"
#include "app/window/main_window.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

QString pointFileFilter() {
  return QObject::tr(
      "Point files (*.ply *.obj *.off *.xyz *.txt *.csv *.pts *.ptx *.asc *.sfl);;All files (*)");
}

}  // namespace

void MainWindow::open() {
  const QStringList paths =
      QFileDialog::getOpenFileNames(this, tr("Open scans"), settings_.folder(), pointFileFilter());
  for (const QString& path : paths) {
    settings_.setFolder(QFileInfo(path).absolutePath());
    workbench_.open(path.toStdString());
  }
}

bool MainWindow::save() {
  const OpenScan* scan = workbench_.current();
  if (!scan) return false;
  if (scan->isSample || scan->document.path().empty()) return saveAs();
  // A format that would lose attributes is not written over in passing.
  const QString path = QString::fromStdString(scan->document.path().string());
  if (!path.endsWith(".ply", Qt::CaseInsensitive)) return saveAs();
  workbench_.save(scan->document.path());
  return true;
}

bool MainWindow::saveAs() {
  const OpenScan* scan = workbench_.current();
  if (!scan) return false;
  const QFileInfo before(QString::fromStdString(scan->document.path().string()));
  const QString folder = scan->isSample ? QDir::homePath() : before.absolutePath();
  const QString proposal = QDir(folder).filePath(before.completeBaseName() + ".ply");
  QString path = QFileDialog::getSaveFileName(
      this, tr("Save as"), proposal,
      tr("PLY, keeps everything (*.ply);;OBJ (*.obj);;OFF (*.off);;Text (*.txt *.xyz)"));
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) path += ".ply";
  workbench_.save(path.toStdString());
  return true;
}

// True where nothing is lost by closing, or the user gives it up.
bool MainWindow::mayClose(int index) {
  OpenScan& scan = *workbench_.scans()[static_cast<std::size_t>(index)];
  if (!scan.document.isModified()) return true;
  workbench_.setCurrent(index);
  QMessageBox box(QMessageBox::NoIcon, tr("Unsaved changes"), tr("Save the changes to %1?").arg(scan.title),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setObjectName("unsaved");
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer == QMessageBox::Cancel) return false;
  if (answer == QMessageBox::Discard) return true;
  return save() && workbench_.finishSaving() && !scan.document.isModified();
}

void MainWindow::closeScan(int index) {
  if (index >= 0 && index < static_cast<int>(workbench_.scans().size()) && mayClose(index))
    workbench_.close(index);
}

void MainWindow::saveRecipe() {
  const OpenScan* scan = workbench_.current();
  if (!scan) return;
  const Document::DoneAsRecipe done = scan->document.recipe();
  QString path =
      QFileDialog::getSaveFileName(this, tr("Save recipe"), settings_.folder(), tr("Recipe (*.json)"));
  if (path.isEmpty()) return;
  settings_.setRecipeFolder(QFileInfo(path).absolutePath());
  if (QFileInfo(path).suffix().isEmpty()) path += ".json";
  QSaveFile file(path);
  const std::string text = formatRecipe(done.recipe);
  const bool isWritten =
      file.open(QIODevice::WriteOnly) &&
      file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size()) &&
      file.commit();
  if (!isWritten) return workbench_.say(tr("%1 cannot be written: %2.").arg(path, file.errorString()));
  QString said = tr("The recipe with %n step(s) is saved.", "", static_cast<int>(done.recipe.steps.size()));
  if (done.leftOut > 0) {
    said += ' ' + tr("%n change(s) depend on this scan or this view and were left out.", "",
                     static_cast<int>(done.leftOut));
  }
  workbench_.say(said);
}

void MainWindow::playRecipe() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Play recipe"), settings_.recipeFolder(), tr("Recipe (*.json)"));
  if (path.isEmpty()) return;
  settings_.setRecipeFolder(QFileInfo(path).absolutePath());
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    return workbench_.say(tr("%1 cannot be read: %2.").arg(path, file.errorString()));
  try {
    workbench_.play(parseRecipe(file.readAll().toStdString(), workbench_.registry()));
  } catch (const Error& error) {
    workbench_.say(tr("%1: %2.").arg(path, QString::fromStdString(error.what())));
  }
}

void MainWindow::saveScreenshot() {
  QString path =
      QFileDialog::getSaveFileName(this, tr("Save picture"), settings_.folder(), tr("Picture (*.png)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += ".png";
  const Image image = view_->viewport().picture();
  const QImage picture(reinterpret_cast<const uchar*>(image.pixels.data()), image.width, image.height,
                       image.width * 4, QImage::Format_RGBA8888);
  workbench_.say(picture.save(path, "PNG") ? tr("The picture is saved as %1.").arg(path)
                                           : tr("%1 cannot be written.").arg(path));
}

void MainWindow::storeNamedSelection() {
  const OpenScan* scan = workbench_.current();
  bool isGiven = false;
  const QString name = QInputDialog::getText(this, tr("Name the selection"), tr("Letters, digits and _"),
                                             QLineEdit::Normal, {}, &isGiven);
  if (!scan || !isGiven) return;
  try {
    workbench_.commit("Name selection " + name.toStdString(),
                      storeSelection(scan->document.points(), name.toStdString()));
  } catch (const Error& error) {
    workbench_.say(QString::fromStdString(error.what()));
  }
}

void MainWindow::recallNamedSelection() {
  const OpenScan* scan = workbench_.current();
  if (!scan) return;
  QStringList names;
  for (const std::string& name : storedSelections(scan->document.points()))
    names << QString::fromStdString(name);
  if (names.isEmpty()) return workbench_.say(tr("This scan has no named selections yet."));
  bool isGiven = false;
  const QString name =
      QInputDialog::getItem(this, tr("Select by name"), tr("Selection"), names, 0, false, &isGiven);
  if (!isGiven) return;
  workbench_.commit("Select " + name.toStdString(),
                    recallSelection(scan->document.points(), name.toStdString()));
}

void MainWindow::focusSearch() {
  search_->setFocus();
  search_->selectAll();
}

void MainWindow::showShortcuts() {
  QDialog dialog(this);
  dialog.setObjectName("shortcuts_dialog");
  dialog.setWindowTitle(tr("All shortcuts"));
  dialog.resize(560, 620);
  auto* table = new QTableWidget(0, 2, &dialog);
  table->horizontalHeader()->hide();
  table->verticalHeader()->hide();
  table->setShowGrid(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  const auto add = [&](const QString& title, const QString& keys) {
    const int row = table->rowCount();
    table->insertRow(row);
    table->setItem(row, 0, new QTableWidgetItem(title));
    table->setItem(row, 1, new QTableWidgetItem(keys));
  };
  for (const std::string& id : commands_->ids()) {
    const QAction* action = commands_->action(id);
    if (!action->shortcut().isEmpty())
      add(action->text(), action->shortcut().toString(QKeySequence::NativeText));
  }
  const std::pair<QString, QString> kMouse[] = {
      {tr("Turn the view"), tr("left drag; with a brush Alt+left drag")},
      {tr("Pan"), tr("middle or right drag")},
      {tr("Zoom toward the cursor"), tr("wheel")},
      {tr("Turn about a point"), tr("double click on it")},
      {tr("Brush size"), tr("[ and ], or Alt+wheel, or F and drag")},
      {tr("Brush strength"), tr("Shift+F and drag")},
      {tr("Brush the other way"), tr("Ctrl while painting")},
      {tr("Smooth"), tr("Shift while painting")},
      {tr("Take a running stroke or process back"), tr("Esc")}};
  for (const auto& [title, keys] : kMouse) add(title, keys);
  auto* column = new QVBoxLayout(&dialog);
  column->addWidget(table);
  dialog.exec();
}

void MainWindow::showPlugins() {
  QString text = tr("<p>Operators of the loaded plugins:</p><ul>");
  for (const auto& held : workbench_.registry().operators()) {
    const OperatorDescription& d = held->description();
    text += QString("<li><b>%1</b>: %2</li>")
                .arg(QString::fromStdString(d.title).toHtmlEscaped(),
                     QString::fromStdString(d.help).toHtmlEscaped());
  }
  text += "</ul>";
  for (const std::string& warning : workbench_.pluginWarnings())
    text += QString("<p>%1</p>").arg(QString::fromStdString(warning).toHtmlEscaped());
  QMessageBox box(QMessageBox::NoIcon, tr("Plugins"), text, QMessageBox::Ok, this);
  PluginSentinel* sentinel = workbench_.sentinel();
  QAbstractButton* turnOn = nullptr;
  if (sentinel && !sentinel->off().empty())
    turnOn = box.addButton(tr("Turn on again at the next start"), QMessageBox::ActionRole);
  box.exec();
  if (turnOn && box.clickedButton() == turnOn) sentinel->turnOnAll();
}

void MainWindow::showAbout() {
  const QString text = tr("<p><b>Stipple %1</b></p><p>Surface processing by finite elements on points.</p>"
                          "<p>The source is under the MIT license; this program links parts of CGAL and "
                          "CHOLMOD, and is therefore under "
                          "the GNU General Public License 3.</p>")
                           .arg(QApplication::applicationVersion());
  QMessageBox(QMessageBox::NoIcon, tr("About Stipple"), text, QMessageBox::Ok, this).exec();
}

void MainWindow::setTheme(Theme theme) {
  settings_.setTheme(theme);
  applyTheme(*qApp, theme);
  commands_->recolorIcons();
  view_->setTheme(theme);
}

void MainWindow::refreshRecent() {
  if (!recent_) return;
  recent_->clear();
  for (const QString& path : settings_.recentFiles())
    recent_->addAction(path, this, [this, path] { workbench_.open(path.toStdString()); });
  recent_->setEnabled(!recent_->isEmpty());
}

}  // namespace stipple
