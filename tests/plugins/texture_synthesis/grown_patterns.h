#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plugins/texture_synthesis/texture_synthesis.h"

namespace stipple {

using Settings = std::vector<std::pair<std::string, ParameterValue>>;

Parameters textureSettings(const Settings& settings);

/// Runs the operator to its end.
PointSet growPattern(const PointSet& points, const Settings& settings, Report* report = nullptr);

double reported(const Report& report, const std::string& name);

/// Spots of a field: connected parts, over links to the 8 nearest points, of what lies above the middle
/// between its 2 % and 98 % quantiles (below it where `isHigh` is false). Parts of less than `least` points
/// do not count.
int countSpots(const PointSet& points, std::span<const float> values, bool isHigh, int least = 3);

/// Distance of neighbors in a hexagonal packing of so many spots: sqrt(2 A / (sqrt(3) N)).
double hexagonalDistance(double area, int spots);

/// Distance from stripe to stripe, by how often links to the 8 nearest points cross the middle of the field
/// (Cauchy and Crofton: segments of length d cross lines of length l on an area A in 2 l d / (pi A) of all
/// cases).
double stripeDistance(const PointSet& points, std::span<const float> values);

/// Points of the unit sphere in a Fibonacci spiral.
std::vector<Eigen::Vector3f> fibonacciSphere(int count);

}  // namespace stipple
