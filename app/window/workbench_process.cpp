// The part of the workbench that runs operators and plays recipes.
#include <algorithm>

#include "app/document/merge.h"
#include "app/window/sentence.h"
#include "app/window/work_in_progress.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

// All steps, each as an edit of what the one before left.
std::vector<HistoryEntry> playSteps(const Registry& registry, const Recipe& recipe, PointSet points,
                                    Progress& progress) {
  std::vector<HistoryEntry> entries;
  const auto count = static_cast<double>(recipe.steps.size());
  for (const Recipe::Step& step : recipe.steps) {
    const auto at = static_cast<double>(entries.size());
    PartialProgress part(progress, at / count, (at + 1) / count);
    HistoryEntry entry{.title = {}, .edit = {}, .recipeStep = step};
    PointSet after;
    if (const auto* invocation = std::get_if<Invocation>(&step)) {
      entry.title = registry.find(invocation->operatorId)->description().title;
      const RunResult result = invoke(registry, *invocation, points, part).result;
      entry.edit = difference(points, result.points, result.removedRows);
      after = result.points;
    } else {
      const auto& stroke = std::get<Stroke>(step);
      entry.title = "Paint " + stroke.attribute;
      after = applyStroke(points, stroke, part);
      entry.edit = difference(points, after);
    }
    points = std::move(after);
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace

void Workbench::run(const Invocation& invocation, bool startsPaused) {
  OpenScan* scan = current();
  if (!scan || scan->document.isInStroke()) return;
  if (job_) return say(tr("%1 is still running.").arg(QString::fromStdString(job_->title)));
  try {
    job_ = std::make_unique<RunningJob>(
        RunningJob{.scan = scan,
                   .title = makeTitle(invocation.operatorId),
                   .position = scan->document.history().position(),
                   .job = OperatorJob(registry_, invocation, scan->document.points(),
                                      {.startPaused = startsPaused, .threads = threads_}),
                   .watch = watchPlugin(invocation.operatorId)});
  } catch (const std::exception& error) {
    return say(sentenceOf(error));
  }
  keepTicking();
  emit processChanged();
}

std::unique_ptr<PluginSentinel::Watch> Workbench::watchPlugin(const std::string& operatorId) const {
  const auto file = pluginFiles_.find(operatorId);
  if (!options_.sentinel || file == pluginFiles_.end()) return nullptr;
  return options_.sentinel->watch(file->second);
}

std::string Workbench::makeTitle(const std::string& operatorId) const {
  const Operator* op = registry().find(operatorId);
  return op ? op->description().title : operatorId;
}

OpenScan* Workbench::processScan() const {
  return job_ ? job_->scan : nullptr;
}

std::optional<ProcessState> Workbench::process() const {
  if (!job_) return {};
  const JobStatus status = job_->job.status();
  return ProcessState{.operatorId = job_->job.invocation().operatorId,
                      .title = job_->title,
                      .message = status.progress.message,
                      .isPaused = status.state == JobState::kPaused,
                      .isInStep = status.inStep,
                      .fraction = status.progress.fraction,
                      .secondsLeft = status.progress.secondsLeft,
                      .steps = status.steps,
                      .curve = job_->curve};
}

void Workbench::pause() {
  if (job_) job_->job.pause();
  emit processChanged();
}

void Workbench::resume() {
  if (job_) job_->job.resume();
  emit processChanged();
}

void Workbench::togglePause() {
  if (const auto state = process(); state && state->isPaused)
    resume();
  else
    pause();
}

void Workbench::stepOnce() {
  if (job_) job_->job.stepOnce();
}

void Workbench::stop() {
  if (job_) job_->job.stop();
}

void Workbench::setProcessParameters(const Parameters& parameters) {
  if (job_) job_->job.set(parameters);
}

void Workbench::cancel() {
  if (!job_) return;
  job_->job.cancel();
  finishJob();
  say(tr("Cancelled; the surface is as it was."));
}

void Workbench::followJob() {
  if (!job_) return;
  const JobStatus status = job_->job.status();
  const std::vector<double> fresh = job_->job.takeCurve();
  job_->curve.insert(job_->curve.end(), fresh.begin(), fresh.end());
  if (status.state == JobState::kFinished) return commitJob();
  if (status.state == JobState::kFailed) say(QString::fromStdString(status.failure));
  if (status.state == JobState::kFailed || status.state == JobState::kCancelled) return finishJob();
  if (const auto state = job_->job.takePreview(); state && job_->scan == current())
    emit previewChanged(*state);
  emit processChanged();
}

// What the process made, against the points as they are by now.
void Workbench::commitJob() {
  OpenScan& scan = *job_->scan;
  // A stroke that is going on ends first.
  if (scan.document.isInStroke()) return;
  try {
    const auto done = job_->job.takeResult();
    if (!done) return;
    MergedRun merged = mergeRun(*done, scan.document.points());
    const std::vector<Edit::Touched> touched = merged.edit.touched();
    if (merged.edit.empty()) say(tr("%1 changed nothing.").arg(QString::fromStdString(job_->title)));
    scan.document.commit(job_->title, std::move(merged.edit), Recipe::Step(job_->job.invocation()));
    if (merged.keptByUser > 0)
      say(tr("%n point(s) that were changed meanwhile keep what was done by hand.", "",
             static_cast<int>(merged.keptByUser)));
    if (!done->report.warnings.empty()) say(QString::fromStdString(done->report.warnings.front()));
    showResult(scan, job_->job.invocation().operatorId, touched);
  } catch (const std::exception& error) {
    say(sentenceOf(error));
  }
  finishJob();
}

void Workbench::finishJob() {
  const std::unique_ptr<RunningJob> ended = std::move(job_);
  keepTicking();
  if (ended->scan == current()) emit previewEnded();
  tellPointsChanged();
  emit processChanged();
}

// The attribute that the operator is about is what the user wants to see, unless it changed what is shown.
void Workbench::showResult(OpenScan& scan, const std::string& operatorId,
                           const std::vector<Edit::Touched>& touched) {
  scan.look.marked.clear();
  const std::string& shown = scan.look.colors.attribute;
  if (std::ranges::find(touched, shown.empty() ? "color" : shown, &Edit::Touched::name) != touched.end())
    return;
  for (const std::string& name : registry().find(operatorId)->description().writes) {
    if (name == "triangles") scan.look.asMesh = true;
    const Attribute* attribute = scan.document.points().find(name);
    if (!attribute || attribute->type() == AttributeType::kVector3) continue;
    const bool isColor = attribute->type() == AttributeType::kColor;
    scan.look.colors = ColorSource{.attribute = isColor ? "" : name};
    return;
  }
}

void Workbench::play(const Recipe& recipe) {
  OpenScan* scan = current();
  if (!scan) return;
  if (job_ || playing_) return say(tr("Something is still running."));
  if (recipe.steps.empty()) return say(tr("The recipe has no steps."));
  playing_ = std::make_unique<Playing>(
      Playing{.scan = scan,
              .revision = scan->document.revision(),
              .task = Task<std::vector<HistoryEntry>>(
                  [registry = registry_, recipe, points = scan->document.points()](Progress& progress) {
                    return playSteps(*registry, recipe, points, progress);
                  },
                  {.threads = threads_, .priority = ThreadPriority::kLow})});
  keepTicking();
  emit taskChanged();
}

void Workbench::followPlaying() {
  if (!playing_ || !playing_->task.isDone()) return;
  const std::unique_ptr<Playing> done = std::move(playing_);
  try {
    std::vector<HistoryEntry> entries = done->task.takeResult();
    if (done->scan->document.revision() != done->revision)
      throw InvalidInput("The points were changed while the recipe was played, so nothing of it was done");
    for (HistoryEntry& entry : entries)
      done->scan->document.commit(entry.title, std::move(entry.edit), std::move(entry.recipeStep));
    say(tr("The recipe is played: %n step(s).", "", static_cast<int>(entries.size())));
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    say(sentenceOf(error));
  }
  tellPointsChanged();
  emit taskChanged();
}

}  // namespace stipple
