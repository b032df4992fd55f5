#include <algorithm>
#include <cstring>
#include <optional>

#include "core/error.h"
#include "core/io/numbers.h"
#include "core/io/ply_rows.h"

namespace stipple {

namespace {

template <class T>
std::int64_t load(const std::byte* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<std::int64_t>(value);
}

class BinaryPlyRows final : public PlyRows {
 public:
  BinaryPlyRows(const InputFile& file, std::uint64_t offset, bool swapBytes)
      : cursor_(file, offset), swap_(swapBytes) {}

  bool read(const PlyElement& element, std::byte* row) override {
    for (const PlyProperty& property : element.properties) {
      if (property.isList) {
        if (!skipList(property)) return false;
        continue;
      }
      const std::size_t size = sizeOf(property.type);
      const std::byte* bytes = cursor_.take(size);
      if (!bytes) return false;
      copyNumber(bytes, size, row);
      row += size;
    }
    return true;
  }

  bool readList(const PlyElement& element, std::size_t list, std::vector<std::int64_t>& items) override {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (p == list ? !takeList(property, items) : !skip(property)) return false;
    }
    return true;
  }

  std::uint64_t fewestBytes(const PlyElement& element) const override {
    std::uint64_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
      bytes += sizeOf(property.isList ? property.countType : property.type);
    }
    return bytes;
  }

  std::uint64_t offset() const override { return cursor_.offset(); }

 private:
  void copyNumber(const std::byte* bytes, std::size_t size, std::byte* target) const {
    if (swap_) {
      std::reverse_copy(bytes, bytes + size, target);
    } else {
      std::memcpy(target, bytes, size);
    }
  }

  std::int64_t integer(const std::byte* bytes, ScalarType type) const {
    std::byte native[8];
    copyNumber(bytes, sizeOf(type), native);
    switch (type) {
      case ScalarType::kInt8:
        return load<std::int8_t>(native);
      case ScalarType::kUint8:
        return load<std::uint8_t>(native);
      case ScalarType::kInt16:
        return load<std::int16_t>(native);
      case ScalarType::kUint16:
        return load<std::uint16_t>(native);
      case ScalarType::kInt32:
        return load<std::int32_t>(native);
      case ScalarType::kUint32:
        return load<std::uint32_t>(native);
      case ScalarType::kFloat32:
      case ScalarType::kFloat64:
        break;
    }
    return -1;  // a real number is the index of no point
  }

  std::optional<std::uint64_t> takeCount(const PlyProperty& property) {
    const std::byte* bytes = cursor_.take(sizeOf(property.countType));
    const std::int64_t count = bytes ? integer(bytes, property.countType) : -1;
    if (count < 0) return std::nullopt;
    return static_cast<std::uint64_t>(count);
  }

  bool takeList(const PlyProperty& property, std::vector<std::int64_t>& items) {
    const auto count = takeCount(property);
    const std::size_t size = sizeOf(property.type);
    const std::byte* bytes = count ? cursor_.take(*count * size) : nullptr;
    if (!bytes) return false;
    items.resize(*count);
    for (std::size_t i = 0; i < items.size(); ++i) items[i] = integer(bytes + i * size, property.type);
    return true;
  }

  bool skipList(const PlyProperty& property) {
    const auto count = takeCount(property);
    return count && cursor_.skip(*count * sizeOf(property.type));
  }

  bool skip(const PlyProperty& property) {
    return property.isList ? skipList(property) : cursor_.skip(sizeOf(property.type));
  }

  ByteCursor cursor_;
  bool swap_;
};

}  // namespace

std::unique_ptr<PlyRows> openBinaryPlyRows(const InputFile& file, std::uint64_t offset, bool swapBytes) {
  return std::make_unique<BinaryPlyRows>(file, offset, swapBytes);
}

}  // namespace stipple
