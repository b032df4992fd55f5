// The part of the workbench that grows and shrinks selections.
#include "app/tools/selection.h"
#include "app/window/sentence.h"
#include "app/window/work_in_progress.h"
#include "app/window/workbench.h"

namespace stipple {

namespace {

void applyWidening(OpenScan& scan, Workbench::Widening widening) {
  const PointSet& points = scan.document.points();
  const bool grows = widening == Workbench::Widening::kGrow;
  const SelectionMask before = selectionOf(points);
  const SelectionMask after = grows ? grow(*scan.neighbors, before) : shrink(*scan.neighbors, before);
  scan.document.commit(grows ? "Grow selection" : "Shrink selection",
                       difference(points, withSelection(points, after)));
}

}  // namespace

void Workbench::widenSelection(Widening widening) {
  OpenScan* scan = current();
  if (!scan || scan->document.isInStroke()) return;
  const ColumnId positions = scan->document.points().positionColumn().id();
  if (linking_) {
    if (linking_->scan != scan || linking_->positions != positions)
      return say(tr("Another selection is still growing."));
    linking_->wanted.push_back(widening);
    return;
  }
  if (scan->hasNeighbors()) {
    try {
      applyWidening(*scan, widening);
    } catch (const std::exception& error) {
      say(sentenceOf(error));
    }
    return tellPointsChanged();
  }
  linking_ = std::make_unique<Linking>(Linking{
      .scan = scan,
      .positions = positions,
      .wanted = {widening},
      .task =
          Task<std::shared_ptr<const NeighborGraph>>([points = scan->document.points()](Progress& progress) {
            return std::make_shared<const NeighborGraph>(buildNeighborGraph(points, {}, &progress));
          })});
  keepTicking();
  emit taskChanged();
}

void Workbench::followLinking() {
  // A stroke that is going on ends first.
  if (!linking_ || !linking_->task.isDone() || linking_->scan->document.isInStroke()) return;
  const std::unique_ptr<Linking> done = std::move(linking_);
  OpenScan& scan = *done->scan;
  try {
    scan.neighbors = done->task.takeResult();
    scan.neighborsOf = done->positions;
    if (!scan.hasNeighbors()) throw InvalidInput("The points moved meanwhile, so the selection is as it was");
    for (const Widening widening : done->wanted) applyWidening(scan, widening);
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    say(sentenceOf(error));
  }
  tellPointsChanged();
  emit taskChanged();
}

}  // namespace stipple
