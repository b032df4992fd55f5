#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

namespace stipple {

/// Which state of a document its file holds. A state is the number of entries that are done, given-up ones
/// too.
class SavedState {
 public:
  /// None: a state that is no longer reachable.
  const std::optional<std::size_t>& state() const { return saved_; }
  bool is(std::size_t state) const { return saved_ == state; }
  void save(std::optional<std::size_t> state) { saved_ = state; }

  /// The document shows `state` from `revision` on; none where it is between two states.
  void note(std::uint64_t revision, std::optional<std::size_t> state);
  /// Something else is done after `state`: what was reached from there by redo is lost.
  void branch(std::size_t state);
  /// What the document showed at a revision; none where that cannot be reached or is long ago.
  std::optional<std::size_t> stateAt(std::uint64_t revision) const;

 private:
  std::optional<std::size_t> saved_ = 0;
  std::deque<std::pair<std::uint64_t, std::optional<std::size_t>>> trail_ = {{0, 0}};  // by rising revision
};

}  // namespace stipple
