#include "tests/plugins/inpainting/inpaint_points.h"

#include <cmath>

#include "tests/support/shapes.h"

namespace stipple {

Parameters inpaintingSettings(const Settings& settings) {
  Parameters parameters(makeInpainting()->description().parameters);
  for (const auto& [id, value] : settings) parameters.set(id, value);
  return parameters;
}

PointSet inpaint(const PointSet& points, const std::vector<Index>& masked, const Settings& settings,
                 Report* report) {
  const std::unique_ptr<Run> run =
      makeInpainting()->start(points, regionOfRows(points, masked), inpaintingSettings(settings));
  Progress progress;
  while (!run->step(progress).finished) {
  }
  if (report) *report = run->report();
  return run->result().points;
}

std::vector<Index> rowsAround(const PointSet& points, const Eigen::Vector3f& center, float radius) {
  std::vector<Index> rows;
  for (Index row = 0; row < points.size(); ++row) {
    if ((points.positions()[row] - center).norm() < radius) rows.push_back(row);
  }
  return rows;
}

double holeError(const Texture& texture, const std::string& method, std::uint64_t seed) {
  constexpr int kSide = 100;
  // Scans sample as evenly as a grid that is shaken by a third of its spacing, rather than at random.
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> shake(-0.3f / kSide, 0.3f / kSide);
  std::vector<Eigen::Vector3f> positions = shapes::grid(kSide);
  for (Eigen::Vector3f& p : positions) p += Eigen::Vector3f(shake(random), shake(random), 0);
  PointSet points(positions);
  std::vector<double> values;
  for (const Eigen::Vector3f& p : points.positions()) values.push_back(texture(p));
  const std::vector<Index> hole = rowsAround(points, {0.5f, 0.5f, 0}, 12.f / kSide);
  std::vector<double> damaged = values;
  for (const Index row : hole) damaged[row] = 0;
  points.set("texture", damaged);
  const PointSet filled = inpaint(points, hole, {{"attribute", std::string("texture")}, {"method", method}});
  double sum = 0;
  for (const Index row : hole) sum += std::pow(filled.values<double>("texture")[row] - values[row], 2);
  return std::sqrt(sum / static_cast<double>(hole.size()));
}

}  // namespace stipple
