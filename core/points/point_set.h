#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/points/attribute.h"

namespace stipple {

/// Rows of the three corners.
using Triangle = std::array<Index, 3>;

/// A surface given as points: positions (n x 3, float, relative to a double origin), named attributes of n
/// rows, optionally the triangles of its file. A value: copies share columns until one of them writes. Rows
/// are in the order of the file; there is no hidden reordering.
class PointSet {
 public:
  PointSet() : PointSet(std::vector<Eigen::Vector3f>{}) {}
  explicit PointSet(std::vector<Eigen::Vector3f> positions,
                    const Eigen::Vector3d& origin = Eigen::Vector3d::Zero(),
                    ScalarType fileType = ScalarType::kFloat32);

  Index size() const { return positions_.size(); }
  /// File coordinates = origin + position.
  const Eigen::Vector3d& origin() const { return origin_; }
  std::span<const Eigen::Vector3f> positions() const { return positions_.view<Eigen::Vector3f>(); }
  std::span<Eigen::Vector3f> editPositions() { return positions_.editView<Eigen::Vector3f>(); }
  const Column& positionColumn() const { return positions_; }
  Column& positionColumn() { return positions_; }
  /// float or double, as the file had them.
  ScalarType positionFileType() const { return positionFileType_; }

  std::span<const Attribute> attributes() const { return attributes_; }
  const Attribute* find(std::string_view name) const;
  Attribute* find(std::string_view name);
  bool has(std::string_view name) const { return find(name) != nullptr; }

  /// Throws InvalidInput naming the attribute where it is missing or of another type.
  template <AttributeValue T>
  std::span<const T> values(std::string_view name) const {
    return require(name, Column(std::vector<T>{}).type()).column.template view<T>();
  }
  template <AttributeValue T>
  std::span<T> edit(std::string_view name) {
    return const_cast<Attribute&>(require(name, Column(std::vector<T>{}).type()))
        .column.template editView<T>();
  }
  /// Adds the attribute or replaces its values, keeping the file property where the type stays the same.
  /// Throws InvalidInput where the length differs from size().
  void set(std::string_view name, AttributeValues values);
  void set(std::string_view name, AttributeValues values, FileProperty file);
  /// Puts a whole attribute in place, or appends it at `position` in the list (end by default).
  void insert(Attribute attribute, std::size_t position = static_cast<std::size_t>(-1));
  bool erase(std::string_view name);

  const std::vector<Triangle>& triangles() const { return *triangles_; }
  const std::shared_ptr<const std::vector<Triangle>>& sharedTriangles() const { return triangles_; }
  /// Throws InvalidInput where a corner is not a row.
  void setTriangles(std::vector<Triangle> triangles);

  /// Renewed whenever rows are added or removed: what is bound to rows (regions, hierarchies) compares it.
  ColumnId topologyId() const { return topologyId_; }

  /// Removes the rows (ascending, unique), keeping the order of the rest; triangles that lose a corner go.
  void removeRows(std::span<const Index> rows);
  /// Appends the rows of `more` (its origin must be this one's); attributes that `more` lacks get zeros,
  /// white for colors; attributes that only `more` has are ignored. Triangles of `more` are ignored.
  void appendRows(const PointSet& more);

 private:
  friend class Edit;  // exchanges triangle list and topology when it puts rows back
  const Attribute& require(std::string_view name, AttributeType type) const;

  Column positions_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  ScalarType positionFileType_ = ScalarType::kFloat32;
  std::vector<Attribute> attributes_;
  std::shared_ptr<const std::vector<Triangle>> triangles_ = std::make_shared<std::vector<Triangle>>();
  ColumnId topologyId_ = newColumnId();
};

}  // namespace stipple
