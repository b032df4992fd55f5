// The part of the workbench that runs operators.
#include <algorithm>

#include "app/jobs/merge.h"
#include "app/window/job_notes.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

QString sentenceOf(const std::exception& error) {
  QString text = QString::fromStdString(error.what());
  if (!text.endsWith('.')) text += '.';
  return text;
}

}  // namespace

void Workbench::run(const Invocation& invocation, bool startsPaused) {
  OpenScan* scan = current();
  if (!scan) return;
  if (job_) return say(tr("%1 is still running.").arg(QString::fromStdString(jobNotes_->title)));
  if (scan->document.isInStroke()) return;
  try {
    const PointSet& points = scan->document.points();
    job_ = startJob(registry(), invocation, points, startsPaused);
    jobNotes_ = std::make_unique<JobNotes>(
        JobNotes{.scan = scan,
                 .invocation = invocation,
                 .title = registry().find(invocation.operatorId)->description().title,
                 .snapshot = points,
                 .position = scan->document.history().position()});
  } catch (const std::exception& error) {
    job_.reset();
    return say(sentenceOf(error));
  }
  keepTicking();
  emit processChanged();
}

std::optional<ProcessState> Workbench::process() const {
  if (!job_) return {};
  const OperatorJob::Status status = job_->status();
  return ProcessState{.operatorId = jobNotes_->invocation.operatorId,
                      .title = jobNotes_->title,
                      .message = status.message,
                      .isPaused = status.state == OperatorJob::State::kPaused,
                      .fraction = status.fraction,
                      .secondsLeft = status.secondsLeft,
                      .steps = status.steps,
                      .curve = jobNotes_->curve};
}

void Workbench::pause() {
  if (job_) job_->pause();
  emit processChanged();
}

void Workbench::resume() {
  if (job_) job_->resume();
  emit processChanged();
}

void Workbench::togglePause() {
  if (const auto state = process(); state && state->isPaused)
    resume();
  else
    pause();
}

void Workbench::stepOnce() {
  if (job_) job_->stepOnce();
}

void Workbench::stop() {
  if (job_) job_->stop();
}

void Workbench::setProcessParameters(const Parameters& parameters) {
  if (!job_) return;
  job_->set(parameters);
  jobNotes_->invocation.parameters = parameters;
}

void Workbench::cancel() {
  if (!job_) return;
  job_->cancel();
  finishJob();
  say(tr("Cancelled; the surface is as it was."));
}

void Workbench::followJob() {
  if (!job_) return;
  const OperatorJob::Status status = job_->status();
  const std::vector<float> fresh = job_->takeCurve();
  jobNotes_->curve.insert(jobNotes_->curve.end(), fresh.begin(), fresh.end());
  switch (status.state) {
    case OperatorJob::State::kFinished:
      return commitJob();
    case OperatorJob::State::kFailed:
      say(QString::fromStdString(status.failure));
      return finishJob();
    case OperatorJob::State::kCancelled:
      return finishJob();
    default:
      break;
  }
  if (const auto state = job_->takePreview()) emit previewChanged(&*state);
  emit processChanged();
}

// What the process made, against the points as they are by now.
void Workbench::commitJob() {
  OpenScan& scan = *jobNotes_->scan;
  try {
    OperatorJob::Result done = job_->takeResult();
    Merged merged = mergeResult(jobNotes_->snapshot, done.result, std::move(done.edit), scan.document.points());
    const bool isAnything = !merged.edit.empty();
    scan.document.commit(jobNotes_->title, std::move(merged.edit), Recipe::Step(jobNotes_->invocation));
    if (!isAnything) say(tr("%1 changed nothing.").arg(QString::fromStdString(jobNotes_->title)));
    if (merged.kept > 0)
      say(tr("%n point(s) that were changed meanwhile keep what was done by hand.", "", static_cast<int>(merged.kept)));
    if (!done.report.warnings.empty()) say(QString::fromStdString(done.report.warnings.front()));
    showResult(scan, jobNotes_->invocation);
  } catch (const std::exception& error) {
    say(sentenceOf(error));
  }
  finishJob();
}

void Workbench::finishJob() {
  const std::unique_ptr<JobNotes> notes = std::move(jobNotes_);
  job_.reset();
  keepTicking();
  if (notes->scan == current()) emit previewEnded();
  tellPointsChanged();
  emit processChanged();
}

// The attribute that the operator is about is what the user wants to see.
void Workbench::showResult(OpenScan& scan, const Invocation& invocation) {
  const OperatorDescription& description = registry().find(invocation.operatorId)->description();
  for (const std::string& name : description.writes) {
    const Attribute* attribute = scan.document.points().find(name);
    if (!attribute || attribute->type() == AttributeType::kVector3) continue;
    if (attribute->type() == AttributeType::kColor) scan.look.colors = {};
    else if (scan.look.colors.attribute != name) scan.look.colors = ColorSource{.attribute = name};
    return;
  }
}

}  // namespace stipple
