#include "app/window/workbench.h"

#include <fmt/format.h>

#include <QFileInfo>
#include <algorithm>
#include <chrono>
#include <thread>

#include "app/document/recovery.h"
#include "app/tools/selection.h"
#include "app/window/sentence.h"
#include "app/window/settings.h"
#include "app/window/work_in_progress.h"
#include "core/points/region.h"

namespace stipple {

namespace {

constexpr int kTick = 12;  // milliseconds between looks at what goes on

// Models that come with triangles mostly stand along Y; bare points, as scanners give them, along Z.
UpAxis likelyUpAxis(const PointSet& points) {
  return points.triangles().empty() ? UpAxis::kZ : UpAxis::kY;
}

std::filesystem::path sampleFile() {
  return resourcePath("sample/spot.ply").toStdString();
}

}  // namespace

Workbench::Workbench(LoadedPlugins plugins, Options options)
    : registry_(std::make_shared<const Registry>(std::move(plugins.registry))),
      pluginWarnings_(std::move(plugins.warnings)),
      pluginFiles_(std::move(plugins.files)),
      options_(std::move(options)) {
  timer_.setInterval(kTick);
  connect(&timer_, &QTimer::timeout, this, &Workbench::tick);
}

// Plugins may still be at work for a moment.
Workbench::~Workbench() {
  openings_.clear();
  recovering_.reset();
  saving_.reset();
  preparing_.reset();
  linking_.reset();
  playing_.reset();
  job_.reset();
  threads_.waitForAll(std::chrono::seconds(3));
}

OpenScan* Workbench::current() const {
  return current_ >= 0 ? scans_[static_cast<std::size_t>(current_)].get() : nullptr;
}

void Workbench::setCurrent(int index) {
  if (index == current_ || index < 0 || index >= static_cast<int>(scans_.size())) return;
  emit leavingCurrent();
  current_ = index;
  emit currentChanged();
}

void Workbench::say(const QString& sentence, const QString& details) {
  const QString first = sentence.section('\n', 0, 0);
  emit said(first, first == sentence ? details : sentence);
}

void Workbench::keepTicking() {
  const bool isBusy =
      !openings_.empty() || recovering_ || saving_ || preparing_ || linking_ || playing_ || job_;
  if (isBusy && !timer_.isActive()) timer_.start();
  if (!isBusy) timer_.stop();
}

void Workbench::openSample() {
  open(sampleFile(), true);
}

void Workbench::open(const std::filesystem::path& path, bool isSample) {
  openings_.push_back(std::make_unique<Opening>(Opening{
      path, isSample, Task<ReadResult>([path](Progress& progress) { return readPoints(path, progress); })}));
  keepTicking();
  emit taskChanged();
}

void Workbench::addScan(ReadResult read, const std::filesystem::path& path, bool isSample) {
  auto scan = std::make_unique<OpenScan>(std::move(read.points), path, options_.history);
  scan->isSample = isSample;
  keepJournal(*scan);
  showScan(std::move(scan));
  if (!read.warnings.empty()) {
    QStringList all;
    for (const std::string& warning : read.warnings) all << QString::fromStdString(warning);
    say(all.front(), all.join('\n'));
  }
}

void Workbench::showScan(std::unique_ptr<OpenScan> scan) {
  scan->title = QString::fromStdString(scan->document.path().filename().string());
  scan->camera.setUpAxis(likelyUpAxis(scan->document.points()));
  scan->camera.frame(scan->extent.sphere);
  emit leavingCurrent();
  // A sample that nobody has touched gives way.
  const bool onlySample =
      scans_.size() == 1 && scans_[0]->isSample && scans_[0]->document.history().size() == 0;
  if (onlySample && !isBusyWith(*scans_[0])) scans_.clear();
  scans_.push_back(std::move(scan));
  current_ = static_cast<int>(scans_.size()) - 1;
  emit scansChanged();
  emit currentChanged();
}

bool Workbench::isBusyWith(const OpenScan& scan) const {
  return (job_ && job_->scan == &scan) || (saving_ && saving_->scan == &scan) ||
         (playing_ && playing_->scan == &scan) || (preparing_ && preparing_->scan == &scan) ||
         (linking_ && linking_->scan == &scan);
}

void Workbench::keepJournal(OpenScan& scan) {
  if (options_.journals.empty() || scan.document.keepsJournal()) return;
  try {
    scan.document.keepJournal(
        std::make_unique<Journal>(options_.journals, describeBase(scan.document.path())));
  } catch (const std::exception& error) {
    say(tr("Changes are not kept safe from a breakdown: %1").arg(sentenceOf(error)));
  }
}

std::vector<LostWork> Workbench::lostWork() const {
  if (options_.journals.empty()) return {};
  try {
    return findLostWork(options_.journals);
  } catch (const std::exception&) {
    return {};  // a folder that cannot be read holds nothing for us
  }
}

void Workbench::recover(const LostWork& work) {
  if (recovering_) return;
  recovering_ = std::make_unique<Recovering>(
      Recovering{.work = work,
                 .task = Task<std::shared_ptr<Document>>(
                     [work, registry = registry_, history = options_.history](Progress& progress) {
                       return std::make_shared<Document>(recoverDocument(work, *registry, progress, history));
                     },
                     {.threads = threads_})});
  keepTicking();
  emit taskChanged();
}

void Workbench::followRecovering() {
  if (!recovering_ || !recovering_->task.isDone()) return;
  const std::unique_ptr<Recovering> done = std::move(recovering_);
  try {
    const std::shared_ptr<Document> document = done->task.takeResult();
    auto scan = std::make_unique<OpenScan>(std::move(*document));
    scan->isSample = scan->document.path() == sampleFile();
    showScan(std::move(scan));
    say(tr("The work on %1 is back, with its history.").arg(current()->title));
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    say(sentenceOf(error));
  }
  emit taskChanged();
}

void Workbench::followOpening() {
  if (openings_.empty()) return;
  emit taskChanged();
  if (!openings_.front()->task.isDone()) return;
  const std::unique_ptr<Opening> done = std::move(openings_.front());
  openings_.erase(openings_.begin());
  try {
    addScan(done->task.takeResult(), done->path, done->isSample);
    if (!done->isSample) emit opened(QString::fromStdString(done->path.string()));
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    say(sentenceOf(error));
  }
  emit taskChanged();
}

void Workbench::close(int index) {
  emit leavingCurrent();
  OpenScan* scan = scans_[static_cast<std::size_t>(index)].get();
  if (job_ && job_->scan == scan) cancel();
  if (playing_ && playing_->scan == scan) playing_.reset();
  if (saving_ && saving_->scan == scan) finishSaving();
  if (preparing_ && preparing_->scan == scan) preparing_.reset();
  if (linking_ && linking_->scan == scan) linking_.reset();
  const std::unique_ptr<OpenScan> held = std::move(scans_[static_cast<std::size_t>(index)]);
  scans_.erase(scans_.begin() + index);
  current_ = std::min(current_, static_cast<int>(scans_.size()) - 1);
  emit scansChanged();
  emit currentChanged();
}

void Workbench::closeAll() {
  while (!scans_.empty()) close(static_cast<int>(scans_.size()) - 1);
}

void Workbench::save(const std::filesystem::path& path) {
  OpenScan* scan = current();
  if (!scan) return;
  if (saving_) return say(tr("Another save is still going on."));
  try {
    requireWritableFormat(path);
  } catch (const Error& error) {
    return say(sentenceOf(error));
  }
  const PointSet points = scan->document.points();
  saving_ =
      std::make_unique<Saving>(Saving{scan, path, scan->document.revision(),
                                      Task<std::vector<std::string>>([points, path](Progress& progress) {
                                        return writePoints(path, points, {}, progress);
                                      })});
  keepTicking();
  emit taskChanged();
}

void Workbench::followSaving() {
  if (!saving_) return;
  emit taskChanged();
  if (!saving_->task.isDone()) return;
  const std::unique_ptr<Saving> done = std::move(saving_);
  try {
    const std::vector<std::string> losses = done->task.takeResult();
    const QString name = QString::fromStdString(done->path.filename().string());
    if (losses.empty()) {
      done->scan->document.markSaved(done->path, done->revision);
      done->scan->title = name;
      done->scan->isSample = false;
      say(tr("Saved as %1.").arg(QString::fromStdString(done->path.string())));
      emit opened(QString::fromStdString(done->path.string()));
    } else {
      QStringList all;
      for (const std::string& loss : losses) all << QString::fromStdString(loss);
      say(tr("%1 is written, but cannot hold everything; save as PLY to keep it all.").arg(name),
          all.join('\n'));
    }
  } catch (const Cancelled&) {
    say(tr("Saving was cancelled; the file is as it was."));
  } catch (const std::exception& error) {
    say(sentenceOf(error));
  }
  emit saved();
  emit taskChanged();
}

bool Workbench::finishSaving() {
  if (!saving_) return true;
  OpenScan* scan = saving_->scan;
  while (!saving_->task.isDone()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  followSaving();
  return !scan->document.isModified();
}

void Workbench::commit(const std::string& title, const PointSet& after, std::optional<Recipe::Step> step) {
  const OpenScan* scan = current();
  if (scan) commitEdit(title, difference(scan->document.points(), after), std::move(step));
}

void Workbench::commitEdit(const std::string& title, Edit edit, std::optional<Recipe::Step> step) {
  try {
    current()->document.commit(title, std::move(edit), std::move(step));
  } catch (const Error& error) {
    say(sentenceOf(error));
  }
  tellPointsChanged();
}

void Workbench::flipNormals() {
  const OpenScan* scan = current();
  if (!scan) return;
  PointSet after = scan->document.points();
  const Attribute* normal = after.find("normal");
  if (!normal || normal->type() != AttributeType::kVector3)
    return say(tr("These points have no normals to flip."));
  const bool isPart = after.has(kSelection);
  const Region region = isPart ? regionWhereNotZero(after, kSelection) : Region();
  const std::span<Eigen::Vector3f> normals = after.edit<Eigen::Vector3f>("normal");
  for (Index row = 0; row < after.size(); ++row) {
    if (region.contains(row)) normals[row] = -normals[row];
  }
  // A recipe knows the operator that does the same; what is selected belongs to this scan.
  constexpr const char* kOperator = "flip_normals";
  if (isPart || !registry().find(kOperator)) return commit("Flip normals", after);
  commit("Flip normals", after, Recipe::Step(makeInvocation(registry(), kOperator)));
}

void Workbench::deleteSelection() {
  OpenScan* scan = current();
  if (!scan || !scan->document.points().has(kSelection)) return;
  if (processScan() == scan) return say(tr("Points cannot be removed while a process runs on them."));
  const PointSet& before = scan->document.points();
  const std::vector<Index> rows = regionWhereNotZero(before, kSelection).rows(before.size());
  if (rows.size() == before.size())
    return say(tr("All points are selected; deleting them would leave nothing."));
  PointSet after = before;
  after.removeRows(rows);
  after.erase(kSelection);
  commitEdit("Delete selected points", difference(before, after, rows));
}

void Workbench::tellPointsChanged(Change change) {
  if (change == Change::kGoesOn) {
    emit pointsTouched();
    return;
  }
  takeMessages();
  emit pointsChanged();
}

void Workbench::takeMessages() {
  if (OpenScan* scan = current()) {
    if (const auto message = scan->document.takeMessage()) say(QString::fromStdString(*message));
  }
}

// Undo must not reach behind the start of a process that will commit to what it started from.
bool Workbench::refuseAcrossProcess(std::size_t position) {
  if (!job_ || job_->scan != current() || position >= job_->position) return false;
  say(tr("%1 is running: what was done before it started cannot be undone now. Cancel it first.")
          .arg(QString::fromStdString(job_->title)));
  return true;
}

void Workbench::goTo(std::size_t position) {
  OpenScan* scan = current();
  if (!scan || refuseAcrossProcess(position)) return;
  try {
    scan->document.goTo(position);
  } catch (const Error& error) {
    say(sentenceOf(error));
  }
  tellPointsChanged();
}

void Workbench::undo() {
  const OpenScan* scan = current();
  if (scan && scan->document.history().canUndo()) goTo(scan->document.history().position() - 1);
}

void Workbench::redo() {
  const OpenScan* scan = current();
  if (scan && scan->document.history().canRedo()) goTo(scan->document.history().position() + 1);
}

void Workbench::prepareDistance() {
  OpenScan* scan = current();
  if (!scan || scan->hasDistance()) return;
  const ColumnId positions = scan->document.points().positionColumn().id();
  if (preparing_ && preparing_->scan == scan && preparing_->positions == positions) return;
  const PointSet points = scan->document.points();
  preparing_ = std::make_unique<Preparing>(
      Preparing{scan, positions, Task<std::shared_ptr<const SurfaceDistance>>([points](Progress& progress) {
                  progress.report(0, "preparing the brush");
                  return std::make_shared<const SurfaceDistance>(points, &progress);
                })});
  keepTicking();
  emit taskChanged();
}

void Workbench::followPreparing() {
  if (!preparing_ || !preparing_->task.isDone()) return;
  const std::unique_ptr<Preparing> done = std::move(preparing_);
  try {
    done->scan->distance = done->task.takeResult();
    done->scan->distanceOf = done->positions;
    emit distanceReady();
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    say(sentenceOf(error));
  }
  emit taskChanged();
}

std::optional<TaskStatus> Workbench::task() const {
  const auto named = [](TaskStatus status, const std::string& what) {
    status.message = what;
    return status;
  };
  if (!openings_.empty())
    return named(openings_.front()->task.status(), "reading " + openings_.front()->path.filename().string());
  if (recovering_) return named(recovering_->task.status(), "bringing the work back");
  if (saving_) return named(saving_->task.status(), "saving " + saving_->path.filename().string());
  if (playing_) return playing_->task.status();
  if (linking_) return named(linking_->task.status(), "finding what is next to the selection");
  if (preparing_) return named(preparing_->task.status(), "preparing the brush");
  return {};
}

void Workbench::cancelTask() {
  if (!openings_.empty())
    openings_.front()->task.cancel();
  else if (recovering_)
    recovering_->task.cancel();
  else if (saving_)
    saving_->task.cancel();
  else if (playing_)
    playing_->task.cancel();
  else if (linking_)
    linking_->task.cancel();
  else if (preparing_)
    preparing_->task.cancel();
}

void Workbench::tick() {
  followOpening();
  followRecovering();
  followSaving();
  followPreparing();
  followLinking();
  followPlaying();
  followJob();
  keepTicking();
}

}  // namespace stipple
