#pragma once

#include "app/window/workbench.h"

namespace stipple {

/// What the workbench knows of the process that it runs.
struct Workbench::JobNotes {
  OpenScan* scan;
  Invocation invocation;
  std::string title;
  PointSet snapshot;
  std::size_t position;  ///< in the history when it was started
  std::vector<float> curve = {};
};

}  // namespace stipple
