#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/discretization.h"

namespace stipple {

/// The edges of all fans, each in both directions, as compressed rows.
struct SurfaceGraph {
  std::vector<Index> offsets{0};
  std::vector<Index> neighbors;
  std::vector<float> lengths;         ///< parallel to neighbors
  std::vector<std::uint8_t> blocked;  ///< parallel to neighbors: nothing flows along this edge

  Index size() const { return static_cast<Index>(offsets.size()) - 1; }
  std::optional<Index> findEdge(Index from, Index to) const;
};

/// `isBlocked` must be symmetric; it is called from several threads.
SurfaceGraph buildSurfaceGraph(const Discretization& d, const std::function<bool(Index, Index)>& isBlocked,
                               const Progress* progress);

/// The parts of the surface that edges which are not blocked hold together. Pieces are numbered by their
/// first site.
struct Pieces {
  std::vector<Index> pieceOfSite;
  std::vector<Index> rankOfSite;  ///< place of a site among those of its piece
  std::vector<Index> offsets{0};  ///< compressed rows of sites
  std::vector<Index> sites;       ///< ascending within a piece

  Index size() const { return static_cast<Index>(offsets.size()) - 1; }
  std::span<const Index> of(Index piece) const {
    return {sites.data() + offsets[piece], offsets[piece + 1] - offsets[piece]};
  }
};
Pieces findPieces(const SurfaceGraph& graph);

/// Whether a path of at most `edges` edges that are not blocked leads from one site to the other.
bool isJoined(const SurfaceGraph& graph, Index from, Index to, int edges);

}  // namespace stipple
