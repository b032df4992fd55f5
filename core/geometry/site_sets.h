#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/parallel.h"

namespace stipple {

/// Sets of sites that are joined one pair after the other (union-find with halved paths, Tarjan and van
/// Leeuwen 1984). The root of a set is its smallest member, so that it does not hang on the order of joining.
class SiteSets {
 public:
  /// Each site is a set of its own.
  explicit SiteSets(Index sites) : parent_(sites) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  /// Shortens the paths that it walks: not to be called from several threads.
  Index rootOf(Index site) {
    while (parent_[site] != site) site = parent_[site] = parent_[parent_[site]];
    return site;
  }
  void join(Index a, Index b) {
    a = rootOf(a);
    b = rootOf(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace stipple
