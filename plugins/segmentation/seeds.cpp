#include "plugins/segmentation/seeds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>

namespace stipple {

namespace {

[[noreturn]] void refuse(const std::string& attribute, std::size_t row, double value) {
  throw InvalidInput(attribute + "[" + std::to_string(row) + "] is " + std::to_string(value) +
                     ", expected a whole number (seeds are labels)");
}

template <class T>
std::vector<std::int32_t> toLabels(const std::vector<T>& values, const std::string& attribute) {
  std::vector<std::int32_t> labels(values.size());
  for (std::size_t row = 0; row < values.size(); ++row) {
    const auto value = static_cast<double>(values[row]);
    const bool isLabel =
        value == std::floor(value) && std::abs(value) <= std::numeric_limits<std::int32_t>::max();
    if (!isLabel) refuse(attribute, row, value);
    labels[row] = static_cast<std::int32_t>(values[row]);
  }
  return labels;
}

}  // namespace

std::vector<std::int32_t> readSeeds(const PointSet& points, const std::string& attribute) {
  const Attribute* found = points.find(attribute);
  if (!found) throw InvalidInput("there is no attribute \"" + attribute + "\" with seeds");
  std::vector<std::int32_t> labels = std::visit(
      [&](const auto& values) -> std::vector<std::int32_t> {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if constexpr (std::is_arithmetic_v<Value>) {
          return toLabels(values, attribute);
        } else {
          throw InvalidInput("attribute \"" + attribute + "\" is a " + nameOf(found->type()) +
                             ", seeds must be whole numbers");
        }
      },
      found->column.values());
  if (std::all_of(labels.begin(), labels.end(), [](std::int32_t label) { return label == 0; })) {
    throw InvalidInput("attribute \"" + attribute + "\" is 0 everywhere: it holds no seed");
  }
  return labels;
}

std::vector<std::int32_t> gatherSeeds(const Sites& sites, const std::vector<std::int32_t>& seedOfPoint) {
  std::vector<std::int32_t> seeds(sites.size(), 0);
  for (std::size_t point = 0; point < seedOfPoint.size(); ++point) {
    std::int32_t& seed = seeds[sites.siteOfPoint[point]];
    if (seed == 0) seed = seedOfPoint[point];
  }
  return seeds;
}

int renumberBySize(std::vector<std::int32_t>& labels) {
  std::map<std::int32_t, std::int64_t> sizes;
  for (const std::int32_t label : labels) ++sizes[label];
  sizes.erase(0);
  std::vector<std::pair<std::int64_t, std::int32_t>> order;
  for (const auto& [label, size] : sizes) order.emplace_back(-size, label);
  std::sort(order.begin(), order.end());
  std::map<std::int32_t, std::int32_t> numbers = {{0, 0}};
  for (const auto& [size, label] : order) numbers.emplace(label, static_cast<std::int32_t>(numbers.size()));
  for (std::int32_t& label : labels) label = numbers.at(label);
  return static_cast<int>(order.size());
}

}  // namespace stipple
