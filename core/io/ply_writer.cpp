#include "core/io/ply_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include "core/io/coordinates.h"
#include "core/io/numbers.h"
#include "core/io/row_blocks.h"

namespace stipple {

namespace {

const char* plyName(ScalarType type) {
  switch (type) {
    case ScalarType::kInt8:
      return "char";
    case ScalarType::kUint8:
      return "uchar";
    case ScalarType::kInt16:
      return "short";
    case ScalarType::kUint16:
      return "ushort";
    case ScalarType::kInt32:
      return "int";
    case ScalarType::kUint32:
      return "uint";
    case ScalarType::kFloat32:
      return "float";
    case ScalarType::kFloat64:
      return "double";
  }
  return "";
}

// One property of the file: where its numbers come from and what they become.
struct Target {
  std::string name;
  ScalarType type;
  std::function<void(std::size_t begin, std::size_t end, std::byte* target, std::size_t stride)> encode;
};

template <class Stored, class Get>
auto encoder(Get get) {
  return [get](std::size_t begin, std::size_t end, std::byte* target, std::size_t stride) {
    for (std::size_t row = begin; row < end; ++row, target += stride) {
      const auto value = static_cast<Stored>(get(row));
      std::memcpy(target, &value, sizeof value);
    }
  };
}

template <class Get>
Target makeTarget(std::string name, ScalarType type, Get get) {
  switch (type) {
    case ScalarType::kInt8:
      return {std::move(name), type, encoder<std::int8_t>(get)};
    case ScalarType::kUint8:
      return {std::move(name), type, encoder<std::uint8_t>(get)};
    case ScalarType::kInt16:
      return {std::move(name), type, encoder<std::int16_t>(get)};
    case ScalarType::kUint16:
      return {std::move(name), type, encoder<std::uint16_t>(get)};
    case ScalarType::kInt32:
      return {std::move(name), type, encoder<std::int32_t>(get)};
    case ScalarType::kUint32:
      return {std::move(name), type, encoder<std::uint32_t>(get)};
    case ScalarType::kFloat32:
      return {std::move(name), type, encoder<float>(get)};
    case ScalarType::kFloat64:
      return {std::move(name), type, encoder<double>(get)};
  }
  return {};
}

template <class Integer>
bool fits(std::span<const Integer> values, ScalarType type) {
  if (values.empty()) return !isFloating(type);
  const auto [low, high] = std::ranges::minmax(values);
  const auto within = [low = low, high = high](auto limits) {
    using Limits = decltype(limits);
    return std::in_range<Limits>(low) && std::in_range<Limits>(high);
  };
  switch (type) {
    case ScalarType::kInt8:
      return within(std::int8_t{});
    case ScalarType::kUint8:
      return within(std::uint8_t{});
    case ScalarType::kInt16:
      return within(std::int16_t{});
    case ScalarType::kUint16:
      return within(std::uint16_t{});
    case ScalarType::kInt32:
      return within(std::int32_t{});
    case ScalarType::kUint32:
      return within(std::uint32_t{});
    case ScalarType::kFloat32:
    case ScalarType::kFloat64:
      break;
  }
  return false;
}

// The type of the file where the values still fit, else the type of the column.
ScalarType storedType(const Attribute& attribute) {
  const ScalarType wanted = attribute.file.type;
  switch (attribute.type()) {
    case AttributeType::kFloat:
    case AttributeType::kVector3:
      return isFloating(wanted) ? wanted : ScalarType::kFloat32;
    case AttributeType::kDouble:
      return ScalarType::kFloat64;
    case AttributeType::kInt:
      return fits(attribute.column.view<std::int32_t>(), wanted) ? wanted : ScalarType::kInt32;
    case AttributeType::kUint:
      return fits(attribute.column.view<std::uint32_t>(), wanted) ? wanted : ScalarType::kUint32;
    case AttributeType::kColor:
      return ScalarType::kUint8;
  }
  return wanted;
}

class PlyWriter {
 public:
  PlyWriter(OutputFile& file, const PointSet& points, const WriteOptions& options, Progress& progress)
      : file_(file),
        points_(points),
        ascii_(options.encoding == Encoding::kAscii),
        rows_(file, points.size() + points.triangles().size(), progress) {
    if (points.has("normal")) kept_.insert({"nx", "ny", "nz"});
    if (points.has("color")) kept_.insert({"red", "green", "blue", "alpha"});
    addPosition();
    for (const Attribute& attribute : points.attributes()) addAttribute(attribute);
    for (const Target& target : targets_) rowBytes_ += sizeOf(target.type);
  }

  std::vector<std::string> write() {
    writeHeader();
    writeVertices();
    writeTriangles();
    return std::move(warnings_);
  }

 private:
  void addPosition() {
    for (int axis = 0; axis < 3; ++axis) {
      const std::span<const Eigen::Vector3f> positions = points_.positions();
      const double origin = points_.origin()[axis];
      const std::string name(1, "xyz"[axis]);
      usedNames_.insert(name);
      if (points_.positionFileType() == ScalarType::kFloat64 || origin != 0) {
        targets_.push_back(makeTarget(name, ScalarType::kFloat64, [positions, origin, axis](std::size_t row) {
          return fileCoordinate(origin, positions[row][axis]);
        }));
      } else {
        targets_.push_back(makeTarget(name, ScalarType::kFloat32,
                                      [positions, axis](std::size_t row) { return positions[row][axis]; }));
      }
    }
  }

  void addAttribute(const Attribute& attribute) {
    switch (attribute.type()) {
      case AttributeType::kFloat:
        return addNumbers<float>(attribute);
      case AttributeType::kDouble:
        return addNumbers<double>(attribute);
      case AttributeType::kInt:
        return addNumbers<std::int32_t>(attribute);
      case AttributeType::kUint:
        return addNumbers<std::uint32_t>(attribute);
      case AttributeType::kVector3:
        return addVector(attribute);
      case AttributeType::kColor:
        return addColor(attribute);
    }
  }

  template <class Value>
  void addNumbers(const Attribute& attribute) {
    const std::span<const Value> values = attribute.column.view<Value>();
    const std::string wanted = attribute.file.name.empty() ? "scalar_" + attribute.name : attribute.file.name;
    const ScalarType type = storedType(attribute);
    if (!attribute.file.name.empty() && type != attribute.file.type) {
      warnings_.push_back(
          fmt::format("'{}' is written as {}, its values are beyond the {} that it was read as",
                      attribute.name, plyName(type), plyName(attribute.file.type)));
    }
    const std::string name = kept_.contains(wanted) ? wanted + '_' : wanted;
    if (name != wanted) {
      warnings_.push_back(fmt::format("property '{}' is written as '{}', the name is taken", wanted, name));
    }
    targets_.push_back(makeTarget(freeName(name), type, [values](std::size_t row) { return values[row]; }));
  }

  void addVector(const Attribute& attribute) {
    const std::span<const Eigen::Vector3f> values = attribute.column.view<Eigen::Vector3f>();
    const ScalarType type = storedType(attribute);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string wanted = attribute.name == "normal"
                                     ? fmt::format("n{}", "xyz"[axis])
                                     : fmt::format("{}_{}", attribute.name, "xyz"[axis]);
      targets_.push_back(
          makeTarget(freeName(wanted), type, [values, axis](std::size_t row) { return values[row][axis]; }));
    }
  }

  // Further colors beside `color` get their name in front; they are read back as numbers.
  void addColor(const Attribute& attribute) {
    const std::span<const Rgba8> values = attribute.column.view<Rgba8>();
    const std::string prefix = attribute.name == "color" ? "" : attribute.name + "_";
    const bool alpha = attribute.file.hasAlpha ||
                       std::ranges::any_of(values, [](const Rgba8& color) { return color.a != 255; });
    constexpr std::array<std::pair<const char*, std::uint8_t Rgba8::*>, 4> kChannels = {
        {{"red", &Rgba8::r}, {"green", &Rgba8::g}, {"blue", &Rgba8::b}, {"alpha", &Rgba8::a}}};
    for (const auto& [name, channel] : std::span(kChannels).first(alpha ? 4 : 3)) {
      targets_.push_back(
          makeTarget(freeName(prefix + name), ScalarType::kUint8,
                     [values, channel = channel](std::size_t row) { return values[row].*channel; }));
    }
  }

  // Property names have no blanks and stand once.
  std::string freeName(std::string name) {
    for (char& c : name) {
      if (static_cast<unsigned char>(c) <= ' ') c = '_';
    }
    const std::string wanted = name;
    while (!usedNames_.insert(name).second) name += '_';
    if (name != wanted)
      warnings_.push_back(fmt::format("property '{}' is written as '{}', the name is taken", wanted, name));
    return name;
  }

  void writeHeader() {
    std::string header = fmt::format("ply\nformat {} 1.0\ncomment written by Stipple\nelement vertex {}\n",
                                     ascii_ ? "ascii" : "binary_little_endian", points_.size());
    for (const Target& target : targets_)
      header += fmt::format("property {} {}\n", plyName(target.type), target.name);
    if (!points_.triangles().empty()) {
      header += fmt::format("element face {}\nproperty list uchar int vertex_indices\n",
                            points_.triangles().size());
    }
    file_.write(header + "end_header\n");
  }

  void writeVertices() {
    std::vector<std::byte> block(std::min<std::size_t>(RowBlocks::kRows, points_.size()) * rowBytes_);
    rows_.writeBlocks(points_.size(), [&](std::size_t begin, std::size_t end) {
      std::size_t offset = 0;
      for (const Target& target : targets_) {
        target.encode(begin, end, block.data() + offset, rowBytes_);
        offset += sizeOf(target.type);
      }
      const std::span<const std::byte> rows = std::span(block).first((end - begin) * rowBytes_);
      if (ascii_) {
        writeAsText(rows);
      } else {
        file_.write(rows);
      }
    });
  }

  void writeAsText(std::span<const std::byte> rows) {
    text_.clear();
    for (const std::byte* number = rows.data(); number != rows.data() + rows.size();) {
      for (const Target& target : targets_) {
        text_.appendStored(number, target.type);
        text_.append(&target == &targets_.back() ? '\n' : ' ');
        number += sizeOf(target.type);
      }
    }
    file_.write(text_.view());
  }

  void writeTriangles() {
    const std::span<const Triangle> triangles = points_.triangles();
    if (ascii_) return rows_.writePolygons(triangles, text_);
    rows_.writeBlocks(triangles.size(), [&](std::size_t begin, std::size_t end) {
      for (const Triangle& triangle : triangles.subspan(begin, end - begin)) {
        std::array<std::byte, 1 + sizeof(Triangle)> row{std::byte{3}};
        std::memcpy(row.data() + 1, triangle.data(), sizeof(Triangle));
        file_.write(row);
      }
    });
  }

  OutputFile& file_;
  const PointSet& points_;
  bool ascii_;
  RowBlocks rows_;
  std::vector<Target> targets_;
  std::size_t rowBytes_ = 0;
  std::set<std::string> kept_;  // names that belong to normal and color
  std::set<std::string> usedNames_;
  std::vector<std::string> warnings_;
  TextBuffer text_;
};

}  // namespace

std::vector<std::string> writePly(OutputFile& file, const PointSet& points, const WriteOptions& options,
                                  Progress& progress) {
  return PlyWriter(file, points, options, progress).write();
}

}  // namespace stipple
