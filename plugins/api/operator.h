#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/points/point_set.h"
#include "core/points/region.h"
#include "core/progress.h"
#include "plugins/api/parameter.h"

namespace stipple {

/// none: the operator takes the whole point set. limits: it changes nothing outside. mask: it needs a region.
enum class RegionUse { kNone, kLimits, kMask };
/// "none", "limits", "mask".
const char* nameOf(RegionUse use);

enum class PaintKind { kLabels, kMask, kWeight, kDirection };

/// A parameter of type attribute that users may paint: the window offers the brush and makes the attribute.
struct PaintableInput {
  std::string parameter = {};  ///< its id; empty: the region itself
  PaintKind kind = PaintKind::kMask;
  std::string attribute = {};  ///< name of the attribute that painting makes
  std::string title = {};
};

/// What an operator is: everything that the command line, panels and recipes show of it.
struct OperatorDescription {
  std::string id = {};  ///< lower case, stable, never translated
  std::string title = {};
  std::string help = {};  ///< one or two sentences
  RegionUse region = RegionUse::kNone;
  std::vector<Parameter> parameters = {};
  /// Names of attributes, "position", "triangles"; "<id>": the attribute that the parameter names.
  std::vector<std::string> writes = {};
  std::vector<PaintableInput> paintable = {};
  bool runsAtEndOfStroke = false;  ///< worth running again after each stroke on a paintable input
};

/// What an operator tells beside its result: values by name in a fixed order, and warnings of one sentence.
struct Report {
  using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;
  std::vector<std::pair<std::string, Value>> values = {};
  std::vector<std::string> warnings = {};
};

/// Rows of `points` are those of the snapshot without `removedRows` (ascending rows of the snapshot) in their
/// order, then those that were added.
struct RunResult {
  PointSet points = {};
  std::vector<Index> removedRows = {};
};

struct StepState {
  bool finished = true;
  double fraction = 1;  ///< of the whole run, in [0, 1]
  /// A value worth plotting over the steps, such as the change of this step.
  std::optional<double> curve = {};
};

/// One run of an operator on its snapshot. Used by one thread at a time; between steps the host may show the
/// result, pause, change parameters or drop the run.
class Run {
 public:
  virtual ~Run() = default;
  /// Does the next step. Throws Cancelled when `progress` says so; the result is then that of the step
  /// before.
  virtual StepState step(Progress& progress) = 0;
  /// Acts at the next step.
  virtual void set(const Parameters& parameters) = 0;
  /// The state after the last complete step; the snapshot before the first.
  virtual RunResult result() const = 0;
  virtual Report report() const { return {}; }
};

/// A process on point sets. It reads a snapshot and returns values; it keeps no state and may be started from
/// any thread. It learns nothing of undo, threads, windows or files.
class Operator {
 public:
  virtual ~Operator() = default;
  virtual const OperatorDescription& description() const = 0;
  /// `parameters` are those of the description. Throws InvalidInput where the snapshot lacks what it needs.
  virtual std::unique_ptr<Run> start(PointSet snapshot, Region region,
                                     const Parameters& parameters) const = 0;
};

/// What an operator of a single step is given.
struct OneShotInput {
  const PointSet& points;
  const Region& region;
  const Parameters& parameters;
};

using OneShotFunction =
    std::function<RunResult(const OneShotInput& input, Progress& progress, Report& report)>;

/// An operator whose only step is `function`. A step after set() runs it again on the same snapshot.
std::unique_ptr<Operator> makeOneShot(OperatorDescription description, OneShotFunction function);

}  // namespace stipple
