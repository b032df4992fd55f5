#pragma once

#include "plugins/inpainting/exemplar_level.h"

namespace stipple {

/// Which source a compared patch resembles most, of those that have been tried.
struct Match {
  Index source = kNoRow;                                ///< a site
  float cost = std::numeric_limits<float>::infinity();  ///< mean squared difference, in features^2
};

/// The matches of the compared patches of a level.
using Matches = std::vector<Match>;

/// Lowers the costs of the matches of some rows of `compared`: by all sources where that is affordable, else
/// by what the matches of neighbors lead to and by sources drawn at random (PatchMatch, Barnes et al. 2009,
/// all patches at once: the result does not depend on the number of threads). `confidence` of samples,
/// parallel to rows. There has to be a source.
void search(const ExemplarLevel& level, std::span<const Index> rows, std::span<const SampleArray> confidence,
            std::uint64_t seed, Matches& matches, const Progress* progress = nullptr);

/// A first fill from the rim inward: what lies one step farther in is compared by what has been filled so
/// far.
void fillInLayers(ExemplarLevel& level, Matches& matches, const Progress* progress = nullptr);

/// Features of the targets: weighted means of what the matches of all patches that hold them have in their
/// places, closer matches for more (Wexler et al. 2007).
void vote(ExemplarLevel& level, const Matches& matches, const Progress* progress = nullptr);

/// Each target takes the features in the middle of its match.
void copyCenters(ExemplarLevel& level, const Matches& matches);

/// Matches of a finer level: those of the nearest patch of the coarser one, moved by as much.
Matches refine(const ExemplarLevel& coarse, const Matches& matches, const ExemplarLevel& fine,
               const Progress* progress = nullptr);

}  // namespace stipple
