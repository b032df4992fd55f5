#include "core/geometry/orientation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stipple {

namespace {

// Two sites, the sum of what the triangles in both their fans say (> 0: their normals agree), and n_i . n_j.
struct Pair {
  Index i, j;  // i < j
  float vote;
  float cosine;

  float strength() const { return std::abs(vote) + 0.3f * std::abs(cosine); }
};

bool isStronger(const Pair& a, const Pair& b) {
  if (a.strength() != b.strength()) return a.strength() > b.strength();
  return a.i != b.i ? a.i < b.i : a.j < b.j;
}

// Union-find whose members know their sign relative to the root of their set.
class SignedSets {
 public:
  explicit SignedSets(Index count) : parent_(count), sign_(count, 1), size_(count, 1) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  struct Place {
    Index root;
    int sign;
  };
  // Halves the path on the way; a root has sign 1.
  Place find(Index member) {
    int sign = 1;
    while (parent_[member] != member) {
      const Index up = parent_[member];
      sign_[member] = static_cast<std::int8_t>(sign_[member] * sign_[up]);
      parent_[member] = parent_[up];
      sign *= sign_[member];
      member = parent_[member];
    }
    return {member, sign};
  }
  // Unites the sets so that sign(a) = relative * sign(b); nothing where they are one set already.
  void join(Index a, Index b, int relative) {
    Place to = find(a), from = find(b);
    if (to.root == from.root) return;
    if (size_[to.root] < size_[from.root]) std::swap(to, from);
    parent_[from.root] = to.root;
    sign_[from.root] = static_cast<std::int8_t>(relative * to.sign * from.sign);
    size_[to.root] += size_[from.root];
  }

 private:
  std::vector<Index> parent_;
  std::vector<std::int8_t> sign_;  // relative to the parent
  std::vector<Index> size_;
};

// +1 where b follows a in the fan of `site` with a triangle between them, -1 where a follows b, else 0.
int senseOf(const Fans& fans, Index site, Index a, Index b) {
  const auto spokes = fans.of(site);
  const auto flags = fans.flagsOf(site);
  for (std::size_t s = 0; s < spokes.size(); ++s) {
    if (spokes[s] != a) continue;
    const std::size_t next = s + 1 == spokes.size() ? 0 : s + 1;
    if (spokes[next] == b && !(flags[s] & Fans::kGapAfter)) return 1;
    const std::size_t previous = s == 0 ? spokes.size() - 1 : s - 1;
    return spokes[previous] == b && !(flags[previous] & Fans::kGapAfter) ? -1 : 0;
  }
  return 0;
}

// What one triangle of fan i, cyclic (i, a, b), says about i and j, which is a or b: half where only their
// two fans have it.
float voteOf(const Fans& fans, Index i, Index a, Index b, Index j) {
  const int sense = j == a ? senseOf(fans, j, b, i) : senseOf(fans, j, i, a);
  if (sense == 0) return 0;
  const Index third = j == a ? b : a;
  return static_cast<float>(sense) * (senseOf(fans, third, i, j) != 0 ? 1.f : 0.5f);
}

std::vector<Pair> collectVotes(const Discretization& d, const Progress* progress) {
  constexpr std::size_t kBlock = 8192;
  const Fans& fans = d.fans;
  std::vector<std::vector<Pair>> parts((fans.size() + kBlock - 1) / kBlock);
  const auto collect = [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      const auto spokes = fans.of(i);
      const auto flags = fans.flagsOf(i);
      for (std::size_t s = 0; s < spokes.size(); ++s) {
        const Index j = spokes[s];
        if (j < i) continue;
        const std::size_t next = s + 1 == spokes.size() ? 0 : s + 1,
                          previous = s == 0 ? spokes.size() - 1 : s - 1;
        float vote = 0;
        if (!(flags[s] & Fans::kGapAfter)) vote += voteOf(fans, i, j, spokes[next], j);
        if (!(flags[previous] & Fans::kGapAfter)) vote += voteOf(fans, i, spokes[previous], j, j);
        if (vote != 0) parts[begin / kBlock].push_back({i, j, vote, d.normals[i].dot(d.normals[j])});
      }
    }
  };
  parallelFor(fans.size(), kBlock, collect, progress);
  std::vector<Pair> pairs;
  for (const auto& part : parts) pairs.insert(pairs.end(), part.begin(), part.end());
  return pairs;
}

// Spokes between sites of different sets.
std::vector<Pair> collectSeams(const Discretization& d, SignedSets& sets) {
  std::vector<Pair> seams;
  for (Index i = 0; i < d.size(); ++i) {
    const Index root = sets.find(i).root;
    for (const Index j : d.fans.of(i)) {
      if (sets.find(j).root == root) continue;
      seams.push_back({std::min(i, j), std::max(i, j), 0, d.normals[i].dot(d.normals[j])});
    }
  }
  return seams;
}

// +1 or -1 where the reference is within 60 degrees of the normal or its opposite, else 0.
std::vector<int> compareWith(const std::vector<Eigen::Vector3f>& reference, const Discretization& d) {
  std::vector<int> signs(d.size(), 0);
  for (Index i = 0; i < d.size(); ++i) {
    const float length = reference[i].norm(), along = reference[i].dot(d.normals[i]);
    if (length > 0.5f && std::abs(along) > 0.5f * length) signs[i] = along > 0 ? 1 : -1;
  }
  return signs;
}

// The signs that normals of the file give, or none at all: where most of them are far from the surface's
// normal (a constant, another quantity), or where a quarter of the votes contradicts them (signs of chance).
std::vector<int> signsOfFile(const Discretization& d, const PointSet& points,
                             const std::vector<Pair>& pairs) {
  const auto reference = sumNormals(d.sites, points);
  if (reference.empty()) return {};
  std::vector<int> signs = compareWith(reference, d);
  const auto given = std::ranges::count_if(reference, [](const auto& v) { return v.norm() > 0.5f; });
  const auto used = std::ranges::count_if(signs, [](int sign) { return sign != 0; });
  if (4 * used < 3 * given) return {};

  std::size_t compared = 0, against = 0;
  for (const Pair& pair : pairs) {
    const float agreement = pair.vote * static_cast<float>(signs[pair.i] * signs[pair.j]);
    compared += agreement != 0;
    against += agreement < 0;
  }
  return 4 * against > compared ? std::vector<int>{} : signs;
}

// The top tenth of a set: any plane cuts from a closed surface a part whose outward normals sum up to the
// area of the cut, straight up; so the sum knows up even where single normals at a tip do not.
struct Top {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();

  bool contains(float z) const { return z >= high - 0.1f * (high - low); }
  // Up; for a vertical sheet along y, then x.
  int sign() const {
    const double tolerance = 1e-3 * sum.norm();
    for (const int axis : {2, 1, 0}) {
      if (std::abs(sum[axis]) > tolerance) return sum[axis] > 0 ? 1 : -1;
    }
    return 1;
  }
};

std::vector<Top> findTops(const Discretization& d, SignedSets& sets) {
  std::vector<Top> tops(d.size() + 1);  // what the file says may be a root too
  for (Index i = 0; i < d.size(); ++i) {
    Top& top = tops[sets.find(i).root];
    top.low = std::min(top.low, d.sites.positions[i].z());
    top.high = std::max(top.high, d.sites.positions[i].z());
  }
  for (Index i = 0; i < d.size(); ++i) {
    const SignedSets::Place place = sets.find(i);
    Top& top = tops[place.root];
    if (!top.contains(d.sites.positions[i].z())) continue;
    top.sum += place.sign * d.mass[i] * d.normals[i].cast<double>();
  }
  return tops;
}

}  // namespace

std::vector<Eigen::Vector3f> sumNormals(const Sites& sites, const PointSet& points) {
  const Attribute* const attribute = points.find("normal");
  if (attribute == nullptr || attribute->type() != AttributeType::kVector3) return {};
  const auto values = attribute->column.view<Eigen::Vector3f>();
  std::vector<Eigen::Vector3f> sums(sites.size(), Eigen::Vector3f::Zero());
  for (std::size_t p = 0; p < values.size(); ++p) {
    const Eigen::Vector3f unit = values[p].stableNormalized();
    if (unit.allFinite()) sums[sites.siteOfPoint[p]] += unit;
  }
  return sums;
}

Orientation orientNormals(const Discretization& d, const PointSet& points, const Progress* progress) {
  std::vector<Pair> pairs = collectVotes(d, progress);

  // One member more: what the file says about outside.
  const Index outside = d.size();
  SignedSets sets(d.size() + 1);
  std::vector<int> given = signsOfFile(d, points, pairs);
  if (given.empty() && d.options.scheme == Scheme::kMesh) given.assign(d.size(), 1);
  for (Index i = 0; i < given.size(); ++i) {
    if (given[i] != 0) sets.join(outside, i, given[i]);
  }

  std::sort(pairs.begin(), pairs.end(), isStronger);
  for (const Pair& pair : pairs) sets.join(pair.i, pair.j, pair.vote > 0 ? 1 : -1);
  if (progress != nullptr) progress->throwIfCancelled();

  std::vector<Pair> seams = collectSeams(d, sets);
  std::sort(seams.begin(), seams.end(), isStronger);
  for (const Pair& seam : seams) sets.join(seam.i, seam.j, seam.cosine >= 0 ? 1 : -1);

  const std::vector<Top> tops = findTops(d, sets);
  const SignedSets::Place file = sets.find(outside);
  Orientation orientation;
  orientation.normals = d.normals;
  for (Index i = 0; i < d.size(); ++i) {
    const SignedSets::Place place = sets.find(i);
    const int whole = place.root == file.root ? file.sign : tops[place.root].sign();
    if (place.sign * whole < 0) orientation.normals[i] = -orientation.normals[i];
  }

  orientation.votes = static_cast<Index>(pairs.size());
  for (const Pair& pair : pairs) {
    const bool agree = sets.find(pair.i).sign == sets.find(pair.j).sign;
    orientation.conflicts += agree != (pair.vote > 0);
  }
  return orientation;
}

}  // namespace stipple
