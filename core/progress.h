#pragma once

#include <string_view>

#include "core/error.h"

namespace stipple {

class PointSet;

/// The one callback of the core: how far a computation is, what it has so far, whether to stop.
/// `report` and `publish` are called on the thread that started the computation; `cancelled` on any thread.
class Progress {
 public:
  virtual ~Progress() = default;
  /// `fraction` in [0, 1], never falling within one computation.
  virtual void report(double /*fraction*/, std::string_view /*message*/) {}
  /// An intermediate state worth showing. Only the result of the computation becomes an undo step.
  virtual void publish(const PointSet& /*state*/) {}
  virtual bool cancelled() const { return false; }

  void throwIfCancelled() const {
    if (cancelled()) throw Cancelled();
  }
};

/// Maps the fractions of one part of a computation to [begin, end] of the whole.
class PartialProgress final : public Progress {
 public:
  PartialProgress(Progress& whole, double begin, double end) : whole_(whole), begin_(begin), end_(end) {}
  void report(double fraction, std::string_view message) override {
    whole_.report(begin_ + fraction * (end_ - begin_), message);
  }
  void publish(const PointSet& state) override { whole_.publish(state); }
  bool cancelled() const override { return whole_.cancelled(); }

 private:
  Progress& whole_;
  double begin_, end_;
};

}  // namespace stipple
