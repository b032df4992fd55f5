#include "plugins/inpainting/patch_search.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/geometry/nearest_points.h"

namespace stipple {

namespace {

constexpr std::size_t kBlock = 64;
// Keeps means defined where no match is close.
constexpr float kLeastWeight = 1e-20f;
// Pairs of patches that are all compared: a tenth of a second or less.
constexpr std::size_t kAllPairs = 1'000'000;
constexpr std::uint64_t kSweeps = 4;
constexpr std::size_t kPropagating = 12;  // neighbors whose matches are followed
constexpr int kDraws = 6;                 // sources drawn anywhere; as many around the match

std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// One patch of the level and what it is compared with.
class Comparison {
 public:
  Comparison(const ExemplarLevel& level, Index row, const SampleArray& confidence)
      : level_(level), confidence_(confidence), samples_(kSamples * level.features.cols()) {
    samplePatch(level.stencils[row], level.features, samples_.data());
  }

  // Stops counting at `least`.
  float costOf(Index site, float least) const {
    float cost = 0;
    const float* source = level_.patches.row(site).data();
    for (Eigen::Index c = 0; c < level_.features.cols() && cost < least; ++c) {
      const Eigen::Map<const SampleArray> a(samples_.data() + c * kSamples), b(source + c * kSamples);
      cost += (confidence_ * (a - b).square()).sum();
    }
    return cost;
  }

  // Sites that are no sources are passed over.
  void consider(Index site, Match& match) const {
    if (!level_.isSource[site] || site == match.source) return;
    const float cost = costOf(site, match.cost);
    if (cost < match.cost) match = {site, cost};
  }
  void considerAll(Match& match) const {
    for (const Index site : level_.sources) consider(site, match);
  }
  void measure(Match& match) const {
    match.cost = std::numeric_limits<float>::infinity();
    if (match.source != kNoRow) match.cost = costOf(match.source, match.cost);
  }

 private:
  const ExemplarLevel& level_;
  const SampleArray& confidence_;
  std::vector<float> samples_;
};

// A site near `site`, at most two steps from it.
Index wander(const TangentPlaces& surface, Index site, std::uint64_t random) {
  for (int step = 0; step < 2; ++step, random >>= 16) {
    const std::span<const Index> neighbors = surface.of(site);
    if (neighbors.empty()) break;
    site = neighbors[random % neighbors.size()];
  }
  return site;
}

// By what the matches of neighbors lead to, and by chance.
void tryCandidates(const ExemplarLevel& level, const Comparison& comparison, const Matches& matches,
                   Index row, std::uint64_t random, Match& match) {
  const Index site = level.compared[row];
  const std::span<const Index> neighbors = level.surface.of(site);
  const std::span<const Eigen::Vector2f> places = level.surface.placesOf(site);
  for (std::size_t n = 0; n < std::min(kPropagating, neighbors.size()); ++n) {
    const Index other = level.comparedRows[neighbors[n]];
    if (other == kNoRow || matches[other].source == kNoRow) continue;
    comparison.consider(level.surface.nearest(matches[other].source, -places[n]), match);
  }
  for (int draw = 0; draw < kDraws; ++draw) {
    random = mixed(random);
    comparison.consider(level.sources[random % level.sources.size()], match);
    if (match.source != kNoRow) comparison.consider(wander(level.surface, match.source, random >> 20), match);
  }
}

// What a patch that holds a target says about it.
struct Ballot {
  Index source;  // the known site in its place
  float cost;
  int hops;  // of the middle of the patch
};

// Calls body(ballot) for all patches that hold the target, its own first.
template <class Body>
void forBallots(const ExemplarLevel& level, const Matches& matches, Index target, const Body& body) {
  const Match& own = matches[level.comparedRows[target]];
  body(Ballot{own.source, own.cost, level.hops[target]});
  const std::span<const Index> neighbors = level.surface.of(target);
  const std::span<const Eigen::Vector2f> places = level.surface.placesOf(target);
  for (std::size_t n = 0; n < neighbors.size(); ++n) {
    const Index row = level.comparedRows[neighbors[n]];
    if (row == kNoRow || places[n].norm() > kPatchRadius) continue;
    const Index source = level.surface.nearest(matches[row].source, -places[n]);
    if (level.kinds[source] != Surround::Kind::kKnown) continue;
    body(Ballot{source, matches[row].cost, level.hops[neighbors[n]]});
  }
}

}  // namespace

void search(const ExemplarLevel& level, std::span<const Index> rows, std::span<const SampleArray> confidence,
            std::uint64_t seed, Matches& matches, const Progress* progress) {
  const bool isSmall = rows.size() * level.sources.size() <= kAllPairs;
  for (std::uint64_t sweep = 0; sweep < (isSmall ? 1 : kSweeps); ++sweep) {
    Matches next(rows.size());
    parallelFor(
        rows.size(), kBlock,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t r = begin; r < end; ++r) {
            const Comparison comparison(level, rows[r], confidence[r]);
            next[r] = matches[rows[r]];
            comparison.measure(next[r]);
            if (isSmall) {
              comparison.considerAll(next[r]);
            } else {
              tryCandidates(level, comparison, matches, rows[r], mixed(mixed(seed + sweep) ^ rows[r]),
                            next[r]);
            }
          }
        },
        progress);
    for (std::size_t r = 0; r < rows.size(); ++r) matches[rows[r]] = next[r];
  }
}

void fillInLayers(ExemplarLevel& level, Matches& matches, const Progress* progress) {
  // What is not filled yet is not quite without a say: the fill before continues edges.
  constexpr float kGuess = 0.02f;
  std::map<int, std::vector<Index>> layers;
  for (Index row = 0; row < level.compared.size(); ++row)
    layers[level.hops[level.compared[row]]].push_back(row);
  std::vector<float> isFilled(level.hops.size());
  for (const auto& [hops, rows] : layers) {
    for (std::size_t site = 0; site < isFilled.size(); ++site)
      isFilled[site] = level.hops[site] < std::max(hops, 1) ? 1 : kGuess;
    std::vector<SampleArray> confidence;
    for (const Index row : rows)
      confidence.push_back(normalized(level.confidence[row] * sampleNumber(level.stencils[row], isFilled)));
    search(level, rows, confidence, static_cast<std::uint64_t>(hops), matches, progress);
    for (const Index row : rows) {
      const Index site = level.compared[row];
      if (level.kinds[site] == Surround::Kind::kTarget)
        level.features.row(site) = level.features.row(matches[row].source);
    }
  }
}

void vote(ExemplarLevel& level, const Matches& matches, const Progress* progress) {
  std::vector<float> costs;
  for (const Match& match : matches) costs.push_back(match.cost);
  const auto place = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() * 3 / 4);
  std::nth_element(costs.begin(), place, costs.end());
  const float scale = std::max(*place, std::numeric_limits<float>::min());
  Features voted(level.targets.size(), level.features.cols());
  parallelFor(
      level.targets.size(), kBlock,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          float weights = 0;
          Eigen::RowVectorXf sum = Eigen::RowVectorXf::Zero(level.features.cols());
          forBallots(level, matches, level.targets[t], [&](const Ballot& ballot) {
            const float weight = std::exp(-ballot.cost / (2 * scale)) * fading(ballot.hops) + kLeastWeight;
            sum += weight * level.features.row(ballot.source);
            weights += weight;
          });
          voted.row(static_cast<Eigen::Index>(t)) = sum / weights;
        }
      },
      progress);
  for (std::size_t t = 0; t < level.targets.size(); ++t)
    level.features.row(level.targets[t]) = voted.row(static_cast<Eigen::Index>(t));
}

void copyCenters(ExemplarLevel& level, const Matches& matches) {
  for (const Index target : level.targets)
    level.features.row(target) = level.features.row(matches[level.comparedRows[target]].source);
}

Matches refine(const ExemplarLevel& coarse, const Matches& matches, const ExemplarLevel& fine,
               const Progress* progress) {
  std::vector<Eigen::Vector3f> from, to;
  for (const Index site : coarse.compared) from.push_back(coarse.surface.positions[site]);
  for (const Index site : fine.compared) to.push_back(fine.surface.positions[site]);
  const std::vector<Index> nearest = findNearestPoints(from, to, progress);
  Matches refined(fine.compared.size());
  for (std::size_t row = 0; row < refined.size(); ++row) {
    const Index middle = coarse.finer[coarse.compared[nearest[row]]];
    const Index source = coarse.finer[matches[nearest[row]].source];
    const Index moved = fine.surface.nearest(source, fine.surface.placeOf(middle, to[row]));
    if (fine.isSource[moved]) {
      refined[row].source = moved;
    } else if (fine.isSource[source]) {
      refined[row].source = source;
    } else {
      refined[row].source = fine.sources[row % fine.sources.size()];
    }
  }
  return refined;
}

}  // namespace stipple
