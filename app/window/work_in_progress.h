#pragma once

#include "app/jobs/operator_job.h"
#include "app/jobs/task.h"
#include "app/window/workbench.h"

namespace stipple {

// What goes on at the workbench while the window lives on.

struct Workbench::Opening {
  std::filesystem::path path;
  bool isSample;
  Task<ReadResult> task;
};

struct Workbench::Recovering {
  LostWork work;
  Task<std::shared_ptr<Document>> task;
};

struct Workbench::Saving {
  OpenScan* scan;
  std::filesystem::path path;
  std::uint64_t revision;
  Task<std::vector<std::string>> task;
};

struct Workbench::Preparing {
  OpenScan* scan;
  ColumnId positions;
  Task<std::shared_ptr<const SurfaceDistance>> task;
};

struct Workbench::Linking {
  OpenScan* scan;
  ColumnId positions;
  std::vector<Widening> wanted;  ///< as soon as the neighbors are known, in this order
  Task<std::shared_ptr<const NeighborGraph>> task;
};

struct Workbench::Playing {
  OpenScan* scan;
  std::uint64_t revision;
  Task<std::vector<HistoryEntry>> task;
};

struct Workbench::RunningJob {
  OpenScan* scan;
  std::string title;
  std::size_t position;  ///< in the history when it was started
  OperatorJob job;
  std::unique_ptr<PluginSentinel::Watch> watch = {};
  std::vector<double> curve = {};
};

}  // namespace stipple
