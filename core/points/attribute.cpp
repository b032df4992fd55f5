#include "core/points/attribute.h"

#include <atomic>
#include <cstring>

namespace stipple {

const char* nameOf(AttributeType type) {
  switch (type) {
    case AttributeType::kFloat:
      return "float";
    case AttributeType::kDouble:
      return "double";
    case AttributeType::kInt:
      return "int";
    case AttributeType::kUint:
      return "uint";
    case AttributeType::kVector3:
      return "vector3";
    case AttributeType::kColor:
      return "color";
  }
  return "";
}

ColumnId newColumnId() {
  static std::atomic<ColumnId> next{1};
  return next++;
}

Index Column::size() const {
  return std::visit([](const auto& values) { return static_cast<Index>(values.size()); }, *values_);
}

AttributeValues& Column::edit() {
  if (values_.use_count() > 1) {
    values_ = std::make_shared<AttributeValues>(*values_);
  } else {
    // use_count() does not order memory; taking a reference does: what a snapshot dropped on another thread
    // has read was read before this write.
    const std::shared_ptr<AttributeValues> acquired = values_;
  }
  id_ = newColumnId();
  return *values_;
}

bool sameBits(const AttributeValues& a, const AttributeValues& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& left) {
        const auto& right = std::get<std::decay_t<decltype(left)>>(b);
        using Value = typename std::decay_t<decltype(left)>::value_type;
        return left.size() == right.size() &&
               (left.empty() ||
                std::memcmp(static_cast<const void*>(left.data()), static_cast<const void*>(right.data()),
                            left.size() * sizeof(Value)) == 0);
      },
      a);
}

}  // namespace stipple
