#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/io/input_file.h"
#include "core/points/attribute.h"

namespace stipple {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::kFloat32;  ///< of the items where it is a list
  bool isList = false;
  ScalarType countType = ScalarType::kUint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties = {};

  bool hasLists() const;
};

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::uint64_t dataOffset = 0;  ///< first byte behind the line end_header
  std::uint64_t lines = 0;
};

/// Throws InvalidInput naming the line that cannot be understood.
PlyHeader readPlyHeader(const InputFile& file);

}  // namespace stipple
