#include "app/document/invocation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "app/document/border.h"

namespace stipple {

namespace {

const Operator& requireOperator(const Registry& registry, const std::string& id) {
  if (const Operator* found = registry.find(id)) return *found;
  std::vector<std::string> ids;
  for (const auto& held : registry.operators()) ids.push_back(held->description().id);
  throw UsageError(
      ids.empty() ? fmt::format("there is no operator '{}', nor any other", id)
                  : fmt::format("there is no operator '{}', expected one of {}", id, fmt::join(ids, ", ")));
}

Region findRegion(const OperatorDescription& description, const std::string& attribute,
                  const PointSet& points) {
  if (attribute.empty()) {
    if (description.region != RegionUse::kMask) return {};
    throw UsageError(fmt::format("operator '{}' needs a region", description.id));
  }
  if (description.region == RegionUse::kNone) {
    throw UsageError(fmt::format("operator '{}' takes no region", description.id));
  }
  if (!points.has(attribute)) {
    throw UsageError(fmt::format("the region attribute '{}' is not in the points", attribute));
  }
  return regionWhereNotZero(points, attribute);
}

void checkAttributes(const Parameters& parameters, const PointSet& points) {
  for (const Parameter& parameter : parameters.declared()) {
    if (parameter.type != ParameterType::kAttribute) continue;
    const std::string& name = parameters.text(parameter.id);
    const bool isChoice = std::ranges::find(parameter.choices, name, &Choice::id) != parameter.choices.end();
    if (!name.empty() && !isChoice && !points.has(name)) {
      throw UsageError(fmt::format("parameter '{}' names the attribute '{}', which is not in the points",
                                   parameter.id, name));
    }
  }
}

// A step reports fractions of its own; the run tells where it stands among all steps.
class StepProgress final : public Progress {
 public:
  StepProgress(Progress& whole, double fraction) : whole_(whole), fraction_(fraction) {}
  void report(double, std::string_view message) override { whole_.report(fraction_, message); }
  void publish(const PointSet& state) override { whole_.publish(state); }
  bool cancelled() const override { return whole_.cancelled(); }

 private:
  Progress& whole_;
  double fraction_;
};

}  // namespace

Invocation makeInvocation(const Registry& registry, const std::string& operatorId) {
  const OperatorDescription& description = requireOperator(registry, operatorId).description();
  return {.operatorId = operatorId, .parameters = Parameters(description.parameters)};
}

std::unique_ptr<Run> startInvocation(const Registry& registry, const Invocation& invocation,
                                     const PointSet& points) {
  const Operator& op = requireOperator(registry, invocation.operatorId);
  const Region region = findRegion(op.description(), invocation.region, points);
  checkAttributes(invocation.parameters, points);
  return startGuarded(op, points, region, invocation.parameters);
}

InvocationResult invoke(const Registry& registry, const Invocation& invocation, const PointSet& points,
                        Progress& progress) {
  const auto run = startInvocation(registry, invocation, points);
  const std::string& title = requireOperator(registry, invocation.operatorId).description().title;
  int steps = 0;
  for (StepState state{.finished = false, .fraction = 0}; !state.finished; ++steps) {
    progress.throwIfCancelled();
    StepProgress stepProgress(progress, state.fraction);
    state = run->step(stepProgress);
    progress.report(state.fraction, title);
  }
  return {.result = run->result(), .report = run->report(), .steps = steps};
}

}  // namespace stipple
