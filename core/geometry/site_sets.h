#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/points/attribute.h"

namespace stipple {

/// Union-find over sites (or any rows); the root of a set is its smallest member.
class SiteSets {
 public:
  explicit SiteSets(Index sites) : parent_(sites) { std::iota(parent_.begin(), parent_.end(), Index{0}); }
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
