#pragma once

#include <span>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// The edges of a list of triangles, each with the triangles that use it.
class MeshEdges {
 public:
  /// `corners`: the rows that corners may name. Triangles that have a corner twice are left out.
  MeshEdges(std::span<const Triangle> triangles, Index corners);

  struct Use {
    Index high;  ///< the other end
    Index triangle;
    bool isUpwards;  ///< the triangle runs from the lower to the higher end
  };
  /// Edges whose lower end this is, by ascending higher end.
  std::span<const Use> from(Index low) const {
    return std::span(uses_).subspan(begins_[low], begins_[low + 1] - begins_[low]);
  }
  /// Uses of the edge between two corners; none where there is no such edge.
  std::span<const Use> of(Index a, Index b) const;
  Index corners() const { return static_cast<Index>(begins_.size()) - 1; }

  /// visit(low, uses of one edge).
  template <class Visit>
  void forEach(const Visit& visit) const {
    for (Index low = 0; low < corners(); ++low) forEachFrom(low, visit);
  }
  template <class Visit>
  void forEachFrom(Index low, const Visit& visit) const {
    const auto uses = from(low);
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
      while (end < uses.size() && uses[end].high == uses[begin].high) ++end;
      visit(low, uses.subspan(begin, end - begin));
    }
  }

 private:
  std::vector<std::size_t> begins_;
  std::vector<Use> uses_;
};

/// What a list of triangles is as a surface.
struct MeshReport {
  Index vertices = 0;  ///< that a triangle uses
  std::size_t edges = 0, boundaryEdges = 0, nonManifoldEdges = 0;
  std::size_t inconsistentEdges = 0;    ///< both triangles run the same way along them
  std::size_t boundaryLoops = 0;        ///< connected sets of boundary edges
  std::size_t nonManifoldVertices = 0;  ///< whose triangles form more than one cycle or chain
  std::size_t components = 0;
  std::int64_t eulerNumber = 0;  ///< V - E + F
};
MeshReport describeMesh(std::span<const Triangle> triangles, Index corners);

}  // namespace stipple
