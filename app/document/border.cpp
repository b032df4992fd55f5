#include "app/document/border.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <string>
#include <utility>

namespace stipple {

namespace {

// What the call returns; its exceptions become failures of the operator.
template <class Call>
auto guarded(const std::string& id, Call&& call) {
  try {
    return call();
  } catch (const Cancelled&) {
    throw;
  } catch (const OperatorFailure&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw OperatorFailure(fmt::format("{}: out of memory", id));
  } catch (const std::exception& error) {
    throw OperatorFailure(fmt::format("{}: {}", id, error.what()));
  } catch (...) {
    throw OperatorFailure(fmt::format("{}: it threw something that is not a std::exception", id));
  }
}

class GuardedRun final : public Run {
 public:
  GuardedRun(std::string id, Index snapshotSize, std::unique_ptr<Run> run)
      : id_(std::move(id)), snapshotSize_(snapshotSize), run_(std::move(run)) {}

  StepState step(Progress& progress) override {
    return guarded(id_, [&] { return run_->step(progress); });
  }
  void set(const Parameters& parameters) override {
    guarded(id_, [&] { run_->set(parameters); });
  }
  Report report() const override {
    return guarded(id_, [&] { return run_->report(); });
  }
  RunResult result() const override {
    return guarded(id_, [&] {
      RunResult result = run_->result();
      check(result);
      return result;
    });
  }

 private:
  void check(const RunResult& result) const {
    const auto& removed = result.removedRows;
    const bool ascending = std::ranges::adjacent_find(removed, std::greater_equal<>()) == removed.end();
    if (!ascending || (!removed.empty() && removed.back() >= snapshotSize_)) {
      throw OperatorFailure(
          fmt::format("{}: its removed rows are not ascending rows of the {} points", id_, snapshotSize_));
    }
    if (result.points.size() + removed.size() < snapshotSize_) {
      throw OperatorFailure(fmt::format("{}: it returned {} of {} points and declared {} removed", id_,
                                        result.points.size(), snapshotSize_, removed.size()));
    }
  }

  std::string id_;
  Index snapshotSize_;
  std::unique_ptr<Run> run_;
};

}  // namespace

std::unique_ptr<Run> startGuarded(const Operator& op, const PointSet& snapshot, const Region& region,
                                  const Parameters& parameters) {
  const std::string id = op.description().id;
  auto run = guarded(id, [&] { return op.start(snapshot, region, parameters); });
  if (!run) throw OperatorFailure(fmt::format("{}: it did not start", id));
  return std::make_unique<GuardedRun>(id, snapshot.size(), std::move(run));
}

}  // namespace stipple
