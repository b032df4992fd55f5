#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"

namespace stipple {

/// 8-bit sRGB color with straight alpha.
struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend bool operator==(const Rgba8&, const Rgba8&) = default;
};

/// The closed set of value types. The order of the alternatives is the order of AttributeType.
using AttributeValues =
    std::variant<std::vector<float>, std::vector<double>, std::vector<std::int32_t>,
                 std::vector<std::uint32_t>, std::vector<Eigen::Vector3f>, std::vector<Rgba8>>;
enum class AttributeType { kFloat, kDouble, kInt, kUint, kVector3, kColor };

template <class T>
concept AttributeValue = std::same_as<T, float> || std::same_as<T, double> || std::same_as<T, std::int32_t> ||
    std::same_as<T, std::uint32_t> || std::same_as<T, Eigen::Vector3f> || std::same_as<T, Rgba8>;

/// "float", "double", "int", "uint", "vector3", "color".
const char* nameOf(AttributeType type);

/// Number type of a property in a file.
enum class ScalarType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

/// How an attribute stood in the file it came from, so that it is written back under the same name and type.
/// An empty name: created by us, written as scalar_<name> (or <name>_x _y _z, red green blue, nx ny nz).
struct FileProperty {
  std::string name;
  ScalarType type = ScalarType::kFloat32;
  bool hasAlpha = false;  ///< colors only: the file had an alpha channel
  friend bool operator==(const FileProperty&, const FileProperty&) = default;
};

/// Identity of one state of a column. Never reused; renewed on every write access.
using ColumnId = std::uint64_t;
ColumnId newColumnId();

/// Copy-on-write values with an identity: copies share, the first write to a shared column clones it.
class Column {
 public:
  Column() : Column(std::vector<float>{}) {}
  explicit Column(AttributeValues values)
      : values_(std::make_shared<AttributeValues>(std::move(values))), id_(newColumnId()) {}

  AttributeType type() const { return static_cast<AttributeType>(values_->index()); }
  Index size() const;
  ColumnId id() const { return id_; }
  const AttributeValues& values() const { return *values_; }
  /// Clones where shared and renews the identity.
  AttributeValues& edit();

  /// Throws std::bad_variant_access where T is not the type.
  template <AttributeValue T>
  std::span<const T> view() const {
    return std::get<std::vector<T>>(*values_);
  }
  template <AttributeValue T>
  std::span<T> editView() {
    return std::get<std::vector<T>>(edit());
  }

 private:
  std::shared_ptr<AttributeValues> values_;
  ColumnId id_;
};

/// A named column of a point set.
struct Attribute {
  std::string name;
  Column column;
  FileProperty file;

  AttributeType type() const { return column.type(); }
};

/// Same type, same length, same bits (NaN equals itself).
bool sameBits(const AttributeValues& a, const AttributeValues& b);

}  // namespace stipple
