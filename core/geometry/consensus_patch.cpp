#include "core/geometry/consensus_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <unordered_map>

#include "core/geometry/local_fan.h"

namespace stipple {

namespace {

constexpr double kTwoPi = 6.283185307179586;

std::uint64_t edgeKey(Index a, Index b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

double circumradiusOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double area2 = (b - a).cross(c - a).norm();
  const double product = (b - a).norm() * (c - a).norm() * (c - b).norm();
  return area2 > 0 ? product / (2 * area2) : std::numeric_limits<double>::infinity();
}

constexpr int kSettled = -1;

// Triangles at an edge: at most two, by their third corners; `triangle` is their place in the accepted list.
struct EdgeFlaps {
  int count = 0;
  std::array<Index, 2> opposite{};
  std::array<int, 2> triangle{kSettled, kSettled};

  void add(Index third, int id) {
    if (count < 2) {
      opposite[static_cast<std::size_t>(count)] = third;
      triangle[static_cast<std::size_t>(count)] = id;
    }
    ++count;
  }
  void replace(Index oldThird, Index newThird, int id) {
    const std::size_t side = opposite[0] == oldThird ? 0 : 1;
    opposite[side] = newThird;
    triangle[side] = id;
  }
};

// Part of a tangent plane that a triangle takes at one corner.
struct Sector {
  double start, length;  // radians, counterclockwise
};

bool overlap(const Sector& a, const Sector& b) {
  constexpr double kSlack = 1e-6;
  double ahead = std::fmod(b.start - a.start, kTwoPi);
  if (ahead < 0) ahead += kTwoPi;
  return ahead < a.length - kSlack || kTwoPi - ahead < b.length - kSlack;
}

// The accepted triangles of a patch and what they occupy.
class Patch {
 public:
  /// `sites` may repeat; linksOf(site): the edges opposite to it of the triangles that are settled.
  using Links = std::vector<std::array<Index, 2>>;
  Patch(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
        std::vector<Index> sites, const std::function<Links(Index)>& linksOf);

  void acceptDisputed(std::span<const VotedTriangle> disputed);
  /// Loops of at most 12 edges with one triangle each, between sites whose own fans expect no boundary.
  void closeSmallHoles(std::span<const std::uint8_t> open);
  void closeLoop(std::vector<Index> loop);
  /// From now on triangles may overlap in a tangent plane, which is poor where the surface is sharp, and fold
  /// up to 11 degrees from the one beside.
  void relax() { isRelaxed_ = true; }
  void flipToDelaunay();
  std::vector<PatchFan> replacedFans(std::span<const std::uint8_t> open) const;
  const std::vector<Triangle>& accepted() const { return accepted_; }

 private:
  struct Corner {
    Index site = 0;
    std::vector<Sector> sectors;
    Links settled;
  };

  std::size_t localOf(Index site) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(sites_, site) - sites_.begin());
  }
  bool contains(Index site) const { return std::ranges::binary_search(sites_, site); }
  Eigen::Vector3d at(Index site) const { return positions_[site].cast<double>(); }

  void addSettled(Corner& corner);
  Sector sectorAt(Index site, Index a, Index b) const;
  bool foldsOver(Index a, Index b, Index third) const;
  bool accept(const Triangle& t);
  bool wantsFlip(Index a, Index b, Index p, Index q) const;
  void flip(Index a, Index b);
  std::optional<PatchFan> chainLinks(Index site, const Links& links, bool mayBeOpen) const;

  std::span<const Eigen::Vector3f> positions_, normals_;
  std::vector<Index> sites_;  // ascending
  std::vector<Corner> corners_;
  std::vector<Triangle> accepted_;
  bool isRelaxed_ = false;
  std::unordered_map<std::uint64_t, EdgeFlaps> edges_;
};

Patch::Patch(std::span<const Eigen::Vector3f> positions, std::span<const Eigen::Vector3f> normals,
             std::vector<Index> sites, const std::function<Links(Index)>& linksOf)
    : positions_(positions), normals_(normals), sites_(std::move(sites)) {
  std::sort(sites_.begin(), sites_.end());
  sites_.erase(std::unique(sites_.begin(), sites_.end()), sites_.end());
  corners_.resize(sites_.size());
  for (std::size_t c = 0; c < sites_.size(); ++c) {
    corners_[c].site = sites_[c];
    corners_[c].settled = linksOf(sites_[c]);
    addSettled(corners_[c]);
  }
}

void Patch::addSettled(Corner& corner) {
  for (const auto& [a, b] : corner.settled) {
    corner.sectors.push_back(sectorAt(corner.site, a, b));
    for (const auto& [end, opposite] : {std::pair{a, b}, std::pair{b, a}}) {
      // An edge inside the patch is seen from both ends: entered by the lower one.
      if (contains(end) && end < corner.site) continue;
      edges_[edgeKey(corner.site, end)].add(opposite, kSettled);
    }
  }
}

Sector Patch::sectorAt(Index site, Index a, Index b) const {
  const TangentBasis basis = tangentBasisOf(normals_[site]);
  const auto angleOf = [&](Index j) {
    const Eigen::Vector3d d = at(j) - at(site);
    return std::atan2(d.dot(basis.e1), d.dot(basis.e0));
  };
  const double angleA = angleOf(a), angleB = angleOf(b);
  const double turn = std::remainder(angleB - angleA, kTwoPi);
  return turn < 0 ? Sector{angleB, -turn} : Sector{angleA, turn};
}

// The new flap would lie within 45 degrees of the one that is there (11 where that closes a hole).
bool Patch::foldsOver(Index a, Index b, Index third) const {
  const double least = isRelaxed_ ? 0.98 : 0.7;
  const auto edge = edges_.find(edgeKey(a, b));
  if (edge == edges_.end() || edge->second.count == 0) return false;
  const Eigen::Vector3d along = (at(b) - at(a)).normalized();
  const auto flap = [&](Index corner) -> Eigen::Vector3d {
    const Eigen::Vector3d d = at(corner) - at(a);
    return d - along * along.dot(d);
  };
  const Eigen::Vector3d old = flap(edge->second.opposite[0]), fresh = flap(third);
  return old.dot(fresh) > least * old.norm() * fresh.norm();
}

bool Patch::accept(const Triangle& t) {
  std::array<Sector, 3> sectors{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Index here = t[c], next = t[(c + 1) % 3], last = t[(c + 2) % 3];
    const auto edge = edges_.find(edgeKey(here, next));
    if (edge != edges_.end() && edge->second.count >= 2) return false;
    if (foldsOver(here, next, last)) return false;
    sectors[c] = sectorAt(here, next, last);
    for (const Sector& taken : corners_[localOf(here)].sectors) {
      if (!isRelaxed_ && overlap(taken, sectors[c])) return false;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const Index here = t[c], next = t[(c + 1) % 3], last = t[(c + 2) % 3];
    corners_[localOf(here)].sectors.push_back(sectors[c]);
    edges_[edgeKey(here, next)].add(last, static_cast<int>(accepted_.size()));
  }
  accepted_.push_back(t);
  return true;
}

void Patch::acceptDisputed(std::span<const VotedTriangle> disputed) {
  struct Ranked {
    int votes;
    double radius;
    Triangle corners;
  };
  std::vector<Ranked> order;
  order.reserve(disputed.size());
  for (const VotedTriangle& t : disputed) {
    order.push_back(
        {t.votes, circumradiusOf(at(t.corners[0]), at(t.corners[1]), at(t.corners[2])), t.corners});
  }
  std::sort(order.begin(), order.end(), [](const Ranked& a, const Ranked& b) {
    if (a.votes != b.votes) return a.votes > b.votes;
    if (a.radius != b.radius) return a.radius < b.radius;
    return a.corners < b.corners;
  });
  for (const Ranked& t : order) accept(t.corners);
}

void Patch::closeSmallHoles(std::span<const std::uint8_t> open) {
  constexpr std::size_t kLongest = 12;
  std::unordered_map<Index, std::vector<Index>> rim;
  for (const auto& [key, flaps] : edges_) {
    const auto low = static_cast<Index>(key >> 32), high = static_cast<Index>(key);
    if (flaps.count != 1 || !contains(low) || !contains(high)) continue;
    rim[low].push_back(high);
    rim[high].push_back(low);
  }
  for (auto& [site, next] : rim) std::sort(next.begin(), next.end());
  std::vector<std::uint8_t> visited(sites_.size(), 0);
  for (const Index start : sites_) {
    if (visited[localOf(start)] || !rim.contains(start)) continue;
    std::vector<Index> loop;
    bool usable = true;
    Index previous = start, here = start;
    do {
      const auto& next = rim[here];
      usable = next.size() == 2 && !open[here] && loop.size() < kLongest;
      if (!usable) break;
      loop.push_back(here);
      const Index forward = next[0] == previous ? next[1] : next[0];
      previous = here;
      here = forward;
    } while (here != start);
    for (const Index site : loop) visited[localOf(site)] = 1;
    if (usable && loop.size() >= 3) closeLoop(std::move(loop));
  }
}

// Cuts ears off the loop, that of the smallest circumradius first.
void Patch::closeLoop(std::vector<Index> loop) {
  while (loop.size() >= 3) {
    std::vector<std::pair<double, std::size_t>> ears;
    for (std::size_t e = 0; e < loop.size(); ++e) {
      const Index a = loop[(e + loop.size() - 1) % loop.size()], b = loop[e], c = loop[(e + 1) % loop.size()];
      const auto chord = edges_.find(edgeKey(a, c));
      const bool taken = loop.size() > 3 && chord != edges_.end() && chord->second.count > 0;
      if (!taken) ears.emplace_back(circumradiusOf(at(a), at(b), at(c)), e);
    }
    std::sort(ears.begin(), ears.end());
    const auto cut = std::ranges::find_if(ears, [&](const auto& ear) {
      const std::size_t e = ear.second;
      return accept({loop[(e + loop.size() - 1) % loop.size()], loop[e], loop[(e + 1) % loop.size()]});
    });
    if (cut == ears.end() || loop.size() == 3) return;
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(cut->second));
  }
}

// The angles that face the edge add up to more than pi, and the two triangles are nearly in one plane.
bool Patch::wantsFlip(Index a, Index b, Index p, Index q) const {
  constexpr double kFlat = 0.8;
  const Eigen::Vector3d pa = at(a) - at(p), pb = at(b) - at(p), qa = at(a) - at(q), qb = at(b) - at(q);
  const Eigen::Vector3d normalP = pa.cross(pb), normalQ = qb.cross(qa);
  const double sineP = normalP.norm(), sineQ = normalQ.norm();
  if (!(sineP > 0) || !(sineQ > 0)) return false;
  if (normalP.dot(normalQ) < kFlat * sineP * sineQ) return false;
  return pa.dot(pb) * sineQ + qa.dot(qb) * sineP < -1e-9 * sineP * sineQ;
}

void Patch::flip(Index a, Index b) {
  const EdgeFlaps old = edges_.at(edgeKey(a, b));
  const auto [p, q] = old.opposite;
  const auto [atP, atQ] = old.triangle;
  edges_.erase(edgeKey(a, b));
  accepted_[static_cast<std::size_t>(atP)] = {p, q, a};
  accepted_[static_cast<std::size_t>(atQ)] = {p, q, b};
  edges_.at(edgeKey(a, p)).replace(b, q, atP);
  edges_.at(edgeKey(a, q)).replace(b, p, atP);
  edges_.at(edgeKey(b, p)).replace(a, q, atQ);
  edges_.at(edgeKey(b, q)).replace(a, p, atQ);
  EdgeFlaps& fresh = edges_[edgeKey(p, q)];
  fresh = {};
  fresh.add(a, atP);
  fresh.add(b, atQ);
}

// Votes and radii pick a diagonal of a quadrilateral by chance where fans disagree; the Delaunay one has the
// nonnegative weight.
void Patch::flipToDelaunay() {
  std::vector<std::array<Index, 2>> queue;
  for (const Triangle& t : accepted_) {
    for (std::size_t c = 0; c < 3; ++c) queue.push_back({t[c], t[(c + 1) % 3]});
  }
  // Each flip lowers the energy of the triangulation in the plane; the bound only guards against rounding.
  for (std::size_t done = 0, most = 20 * queue.size(); done < queue.size() && done < most; ++done) {
    const auto [a, b] = queue[done];
    const auto edge = edges_.find(edgeKey(a, b));
    if (edge == edges_.end() || edge->second.count != 2) continue;
    const auto [p, q] = edge->second.opposite;
    const auto [atP, atQ] = edge->second.triangle;
    if (atP == kSettled || atQ == kSettled || p == q) continue;
    const auto diagonal = edges_.find(edgeKey(p, q));
    if (diagonal != edges_.end() && diagonal->second.count > 0) continue;
    if (!wantsFlip(a, b, p, q)) continue;
    flip(a, b);
    for (const auto& side : {std::array{a, p}, std::array{a, q}, std::array{b, p}, std::array{b, q}})
      queue.push_back(side);
  }
}

// One cycle of all links, or one chain where the site's own fan was open.
std::optional<PatchFan> Patch::chainLinks(Index site, const Links& links, bool mayBeOpen) const {
  if (links.empty()) return std::nullopt;
  std::unordered_map<Index, std::vector<Index>> next;
  for (const auto& [a, b] : links) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  std::vector<Index> ends;
  for (const auto& [spoke, linked] : next) {
    if (linked.size() > 2) return std::nullopt;
    if (linked.size() == 1) ends.push_back(spoke);
  }
  const bool open = !ends.empty();
  if (open && (ends.size() != 2 || !mayBeOpen)) return std::nullopt;

  PatchFan fan{site, open, {}};
  Index previous = site;
  Index here = open ? std::min(ends[0], ends[1]) : links[0][0];
  const Index start = here;
  do {
    fan.spokes.push_back(here);
    const auto& linked = next[here];
    const Index forward = linked[0] != previous ? linked[0] : (linked.size() > 1 ? linked[1] : start);
    previous = here;
    here = forward;
  } while (here != start && fan.spokes.size() <= next.size());
  if (fan.spokes.size() != next.size() || (!open && fan.spokes.size() < 3)) return std::nullopt;
  return fan;
}

std::vector<PatchFan> Patch::replacedFans(std::span<const std::uint8_t> open) const {
  std::vector<Links> links(sites_.size());
  for (std::size_t c = 0; c < sites_.size(); ++c) links[c] = corners_[c].settled;
  for (const Triangle& t : accepted_) {
    for (std::size_t c = 0; c < 3; ++c) links[localOf(t[c])].push_back({t[(c + 1) % 3], t[(c + 2) % 3]});
  }
  std::vector<PatchFan> fans;
  for (std::size_t c = 0; c < sites_.size(); ++c) {
    const Index site = sites_[c];
    std::optional<PatchFan> fan = chainLinks(site, links[c], open[site] != 0);
    if (!fan) continue;
    // Counterclockwise about the normal: the turns from spoke to spoke add up to a positive number.
    double turned = 0;
    const std::size_t triangles = fan->spokes.size() - (fan->open ? 1 : 0);
    const Eigen::Vector3d normal = normals_[site].cast<double>();
    for (std::size_t s = 0; s < triangles; ++s) {
      const Eigen::Vector3d a = at(fan->spokes[s]) - at(site);
      const Eigen::Vector3d b = at(fan->spokes[(s + 1) % fan->spokes.size()]) - at(site);
      turned += normal.dot(a.normalized().cross(b.normalized()));
    }
    if (turned < 0) std::reverse(fan->spokes.begin(), fan->spokes.end());
    fans.push_back(std::move(*fan));
  }
  return fans;
}

// Edges opposite to a site of the triangles on which all three fans agree.
Patch::Links agreedLinks(const Fans& fans, Index site) {
  Patch::Links links;
  const auto spokes = fans.of(site);
  const auto flags = fans.flagsOf(site);
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    if (flags[s] & Fans::kGapAfter) continue;
    const Index a = spokes[s], b = spokes[s + 1 == spokes.size() ? 0 : s + 1];
    if (hasTriangle(fans, a, site, b) && hasTriangle(fans, b, site, a)) links.push_back({a, b});
  }
  return links;
}

}  // namespace

ResolvedPatch resolvePatch(std::span<const Eigen::Vector3f> positions,
                           std::span<const Eigen::Vector3f> normals, const Fans& fans,
                           std::span<const VotedTriangle> disputed) {
  std::vector<Index> sites;
  for (const VotedTriangle& t : disputed) sites.insert(sites.end(), t.corners.begin(), t.corners.end());
  Patch patch(positions, normals, std::move(sites), [&](Index site) { return agreedLinks(fans, site); });
  patch.acceptDisputed(disputed);
  patch.closeSmallHoles(fans.open);
  patch.flipToDelaunay();
  return {patch.replacedFans(fans.open), patch.accepted()};
}

std::vector<Triangle> closeLoop(std::span<const Eigen::Vector3f> positions,
                                std::span<const Eigen::Vector3f> normals, std::span<const Index> loop,
                                std::span<const Triangle> around) {
  const auto linksOf = [&](Index site) {
    Patch::Links links;
    for (const Triangle& t : around) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (t[c] == site) links.push_back({t[(c + 1) % 3], t[(c + 2) % 3]});
      }
    }
    return links;
  };
  std::vector<Triangle> most;
  for (const bool isRelaxed : {false, true}) {
    Patch patch(positions, normals, {loop.begin(), loop.end()}, linksOf);
    if (isRelaxed) patch.relax();
    patch.closeLoop({loop.begin(), loop.end()});
    if (patch.accepted().size() > most.size()) most = patch.accepted();
    if (most.size() + 2 == loop.size()) break;
  }
  return most;
}

}  // namespace stipple
