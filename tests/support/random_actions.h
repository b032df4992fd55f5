#pragma once

#include <bit>
#include <random>
#include <string>
#include <vector>

#include "core/points/point_set.h"

namespace stipple {

/// Changes a point set at random: any bits (NaN among them), any attribute, rows, triangles.
class RandomActions {
 public:
  explicit RandomActions(std::uint32_t seed) : random_(seed) {}

  /// The new state, and in `removed` the rows of the old one that it lacks.
  PointSet changed(const PointSet& points, std::vector<Index>& removed) {
    PointSet next = points;
    const int actions = 1 + below(3);
    if (below(4) == 0) removed = removeSome(next);
    for (int a = 0; a < actions; ++a) changeOnce(next);
    if (below(4) == 0) next.appendRows(PointSet(randomPositions(below(200)), next.origin()));
    return next;
  }

  Index below(Index end) { return std::uniform_int_distribution<Index>(0, end - 1)(random_); }

 private:
  void changeOnce(PointSet& points) {
    switch (below(8)) {
      case 0:
        return paint(points.editPositions(), [this] { return randomVector(); });
      case 1:
        return paintAttribute(points);
      case 2:
        return paintAttribute(points);
      case 3:
        return points.set(randomName(), randomColumn(points.size()));
      case 4:
        points.erase(randomName());
        return;
      case 5:
        return moveAttribute(points);
      case 6:
        return changeFileProperty(points);
      case 7:
        return changeTriangles(points);
    }
  }

  std::vector<Index> removeSome(PointSet& points) {
    std::vector<Index> rows;
    const Index oneOf = 1 + below(40);
    for (Index row = 0; row < points.size(); ++row) {
      if (below(oneOf) == 0) rows.push_back(row);
    }
    points.removeRows(rows);
    return rows;
  }

  template <class T, class Draw>
  void paint(std::span<T> column, Draw draw) {
    const Index oneOf = 1 + below(50);
    for (T& value : column) {
      if (below(oneOf) == 0) value = draw();
    }
  }

  void paintAttribute(PointSet& points) {
    Attribute* attribute = points.find(randomName());
    if (!attribute) return;
    std::visit(
        [this](auto& column) {
          using Value = typename std::decay_t<decltype(column)>::value_type;
          paint(std::span<Value>(column), [this] { return randomValue<Value>(); });
        },
        attribute->column.edit());
  }

  void moveAttribute(PointSet& points) {
    const Attribute* found = points.find(randomName());
    if (!found) return;
    const Attribute attribute = *found;
    points.erase(attribute.name);
    points.insert(attribute, below(6));
  }

  void changeFileProperty(PointSet& points) {
    Attribute* attribute = points.find(randomName());
    if (!attribute) return;
    attribute->file = {below(2) ? "x" : "", static_cast<ScalarType>(below(8)), below(2) == 0};
  }

  void changeTriangles(PointSet& points) {
    std::vector<Triangle> triangles(points.size() == 0 ? 0 : below(30));
    for (Triangle& triangle : triangles) {
      for (Index& corner : triangle) corner = below(points.size());
    }
    points.setTriangles(std::move(triangles));
  }

  template <class T>
  T randomValue() {
    const auto bits = static_cast<std::uint32_t>(random_());
    if constexpr (std::is_same_v<T, Eigen::Vector3f>)
      return randomVector();
    else if constexpr (std::is_same_v<T, Rgba8>)
      return std::bit_cast<Rgba8>(bits);
    else if constexpr (std::is_same_v<T, double>)
      return std::bit_cast<double>(std::uint64_t{bits} << 32 | random_());
    else
      return std::bit_cast<T>(bits);
  }

  Eigen::Vector3f randomVector() {
    return {randomValue<float>(), randomValue<float>(), randomValue<float>()};
  }

  std::vector<Eigen::Vector3f> randomPositions(Index size) {
    std::vector<Eigen::Vector3f> positions(size);
    for (Eigen::Vector3f& position : positions) position = randomVector();
    return positions;
  }

  template <class T>
  std::vector<T> randomValues(Index size) {
    std::vector<T> values(size);
    for (T& value : values) value = randomValue<T>();
    return values;
  }

  AttributeValues randomColumn(Index size) {
    switch (below(6)) {
      case 0:
        return randomValues<float>(size);
      case 1:
        return randomValues<double>(size);
      case 2:
        return randomValues<std::int32_t>(size);
      case 3:
        return randomValues<std::uint32_t>(size);
      case 4:
        return randomValues<Eigen::Vector3f>(size);
      default:
        return randomValues<Rgba8>(size);
    }
  }

  std::string randomName() { return std::string(1, static_cast<char>('a' + below(5))); }

  std::mt19937 random_;
};

}  // namespace stipple
