#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/progress.h"
#include "render/hierarchy/hierarchy.h"

namespace stipple {

struct CutOptions {
  float tau = 3;  ///< pixels: a node whose disc is smaller across is drawn, otherwise its children
  Index budget = 20'000'000;  ///< most nodes of a cut; tau is raised until it fits
  bool cullFrustum = true;
  bool cullBackfaces = true;  ///< only of closed and oriented models, seen from outside
};

/// tau of frames whose mean is shown, given the nodes of a cut of the same view that are seen: down to 2,
/// because the mean does without the filter of coarser nodes, which blurs edges of color; not so low that 16
/// frames of millions of nodes take more than about two seconds of two cores; at most the default.
float tauOfMean(float tau, std::size_t nodes);

/// The nodes that are opened in the last cut: keeps a node as it was until its size passes the threshold
/// clearly.
class CutMemory {
 public:
  bool empty() const { return opened_.empty(); }

 private:
  friend class CutSelection;
  std::vector<std::uint8_t> opened_;  // of inner nodes
};

struct Cut {
  std::vector<Index> nodes;  ///< subtree by subtree, nearest first: neighbors stand together
  float tau = 0;             ///< what was used, at least the wanted one
  bool isComplete = true;    ///< tau is the wanted one
};

/// Every leaf in the view is covered by exactly one node. Thresholds differ from node to node by a fixed
/// hash, so that a uniform sampling does not switch levels all at once. With `memory` a node is opened or
/// closed only where its size passes the threshold by a tenth. Same nodes for any number of threads. Throws
/// Cancelled.
Cut selectCut(const Hierarchy& hierarchy, const View& view, const CutOptions& options,
              CutMemory* memory = nullptr, const Progress* progress = nullptr);

}  // namespace stipple
