#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "plugins/segmentation/segmentation.h"
#include "tests/support/creased_shapes.h"

namespace stipple {

using Settings = std::vector<std::pair<std::string, ParameterValue>>;

Parameters segmentationSettings(const Settings& settings);

/// Runs the operator to its end.
PointSet segmentPoints(const PointSet& points, const Settings& settings, Report* report = nullptr);
std::vector<std::int32_t> segmentsOf(const PointSet& points, const Settings& settings);

/// How labels compare with true faces: purity: share of the labelled points that lie on the face that their
/// label mostly lies on. right: share of all points whose label is the largest one of their face.
struct Score {
  int segments = 0, facesFound = 0;
  double purity = 0, labelled = 0, right = 0;
};
Score score(const std::vector<std::int32_t>& labels, const std::vector<int>& faces);

/// A label at the point nearest to the middle of face 0, 0 elsewhere.
std::vector<std::int32_t> seedInFirstFace(const shapes::FacedPoints& points, std::int32_t label);
/// Share of the points of a face that have the label.
double shareOfFace(const std::vector<std::int32_t>& labels, const std::vector<int>& faces, int face,
                   std::int32_t label);

}  // namespace stipple
