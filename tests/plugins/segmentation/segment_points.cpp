#include "tests/plugins/segmentation/segment_points.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/geometry/site_sets.h"
#include "core/geometry/sites.h"

namespace stipple {

namespace shapes {

namespace {

struct FaceMesh {
  std::vector<std::array<Eigen::Vector3d, 3>> corners;
  std::vector<Eigen::Vector3d> normals;
  std::vector<double> areas;
  std::vector<int> faces;
};

FaceMesh splitAtCreases(const PointSet& mesh, double crease) {
  const Sites sites = weldAndOrder(mesh.positions());
  FaceMesh result;
  std::map<std::pair<Index, Index>, std::vector<Index>> trianglesOfEdge;
  for (const Triangle& t : mesh.triangles()) {
    std::array<Eigen::Vector3d, 3> x;
    for (std::size_t c = 0; c < 3; ++c) x[c] = mesh.positions()[t[c]].cast<double>();
    const Eigen::Vector3d cross = (x[1] - x[0]).cross(x[2] - x[0]);
    if (!(cross.norm() > 0)) continue;
    const auto index = static_cast<Index>(result.areas.size());
    for (std::size_t c = 0; c < 3; ++c) {
      trianglesOfEdge[std::minmax(sites.siteOfPoint[t[c]], sites.siteOfPoint[t[(c + 1) % 3]])].push_back(
          index);
    }
    result.corners.push_back(x);
    result.normals.push_back(cross.normalized());
    result.areas.push_back(0.5 * cross.norm());
  }
  const auto count = static_cast<Index>(result.areas.size());
  SiteSets smooth(count);
  for (const auto& [edge, triangles] : trianglesOfEdge) {
    if (triangles.size() != 2) continue;
    const double cosine = result.normals[triangles[0]].dot(result.normals[triangles[1]]);
    if (std::acos(std::clamp(cosine, -1.0, 1.0)) < crease) smooth.join(triangles[0], triangles[1]);
  }
  std::map<Index, int> numbers;
  for (Index t = 0; t < count; ++t) {
    result.faces.push_back(
        numbers.try_emplace(smooth.rootOf(t), static_cast<int>(numbers.size())).first->second);
  }
  return result;
}

}  // namespace

FacedPoints sampleFaces(const PointSet& mesh, double crease, int count, std::uint64_t seed, double noise) {
  const FaceMesh faces = splitAtCreases(mesh, crease);
  const double spacing = std::sqrt(std::accumulate(faces.areas.begin(), faces.areas.end(), 0.0) / count);
  std::mt19937_64 random(seed);
  std::discrete_distribution<std::size_t> chooseTriangle(faces.areas.begin(), faces.areas.end());
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  FacedPoints points;
  for (int i = 0; i < count; ++i) {
    const std::size_t t = chooseTriangle(random);
    const double r = std::sqrt(uniform(random)), s = uniform(random);
    const auto& x = faces.corners[t];
    const Eigen::Vector3d place = (1 - r) * x[0] + r * (1 - s) * x[1] + r * s * x[2];
    points.positions.push_back((place + noise * spacing * normal(random) * faces.normals[t]).cast<float>());
    points.faces.push_back(faces.faces[t]);
  }
  return points;
}

}  // namespace shapes

Parameters segmentationSettings(const Settings& settings) {
  Parameters parameters(makeSegmentation()->description().parameters);
  for (const auto& [id, value] : settings) parameters.set(id, value);
  return parameters;
}

PointSet segmentPoints(const PointSet& points, const Settings& settings, Report* report) {
  const std::unique_ptr<Run> run =
      makeSegmentation()->start(points, Region(), segmentationSettings(settings));
  Progress progress;
  while (!run->step(progress).finished) {
  }
  if (report) *report = run->report();
  return run->result().points;
}

std::vector<std::int32_t> segmentsOf(const PointSet& points, const Settings& settings) {
  const PointSet result = segmentPoints(points, settings);
  const auto labels = result.values<std::int32_t>("segment");
  return {labels.begin(), labels.end()};
}

Score score(const std::vector<std::int32_t>& labels, const std::vector<int>& faces) {
  std::map<std::int32_t, std::map<int, int>> pointsOf;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != 0) ++pointsOf[labels[i]][faces[i]];
  }
  Score result{.segments = static_cast<int>(pointsOf.size())};
  std::map<int, int> largestOfFace;
  double pure = 0, labelled = 0, right = 0;
  for (const auto& [label, counts] : pointsOf) {
    const auto [face, most] = *std::max_element(
        counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    pure += most;
    for (const auto& [f, count] : counts) labelled += count;
    largestOfFace[face] = std::max(largestOfFace[face], most);
  }
  for (const auto& [face, count] : largestOfFace) right += count;
  const auto count = static_cast<double>(labels.size());
  result.facesFound = static_cast<int>(largestOfFace.size());
  result.purity = labelled > 0 ? pure / labelled : 0;
  result.labelled = labelled / count;
  result.right = right / count;
  return result;
}

std::vector<std::int32_t> seedInFirstFace(const shapes::FacedPoints& points, std::int32_t label) {
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  float count = 0;
  for (std::size_t i = 0; i < points.faces.size(); ++i) {
    if (points.faces[i] != 0) continue;
    middle += points.positions[i];
    ++count;
  }
  middle /= count;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < points.faces.size(); ++i) {
    if ((points.positions[i] - middle).norm() < (points.positions[nearest] - middle).norm()) nearest = i;
  }
  std::vector<std::int32_t> seeds(points.faces.size(), 0);
  seeds[nearest] = label;
  return seeds;
}

double shareOfFace(const std::vector<std::int32_t>& labels, const std::vector<int>& faces, int face,
                   std::int32_t label) {
  double all = 0, with = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (faces[i] != face) continue;
    ++all;
    if (labels[i] == label) ++with;
  }
  return with / all;
}

}  // namespace stipple
