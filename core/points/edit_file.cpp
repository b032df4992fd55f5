#include "core/points/edit_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <utility>

namespace stipple {

namespace {

constexpr std::uint32_t kFormat = 0x31'45'50'53;  // "SPE1"

[[noreturn]] void refuse(std::string_view what) {
  throw InvalidInput(fmt::format("this is not an edit: {}", what));
}

class ByteWriter {
 public:
  template <class T>
  void number(T value) {
    append(&value, sizeof value);
  }
  void text(const std::string& text) {
    number(std::uint64_t{text.size()});
    append(text.data(), text.size());
  }
  template <class T>
  void list(const std::vector<T>& values) {
    number(std::uint64_t{values.size()});
    append(values.data(), values.size() * sizeof(T));
  }
  void column(const Column& column) {
    number(static_cast<std::uint8_t>(column.type()));
    std::visit([this](const auto& values) { list(values); }, column.values());
  }
  std::vector<std::byte> take() { return std::move(bytes_); }
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }

 private:
  void append(const void* from, std::size_t count) {
    const auto* begin = static_cast<const std::byte*>(from);
    bytes_.insert(bytes_.end(), begin, begin + count);
  }

  std::vector<std::byte> bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : left_(bytes) {}

  template <class T>
  T number() {
    T value;
    std::memcpy(&value, take(1, sizeof value).data(), sizeof value);
    return value;
  }
  bool flag() { return number<std::uint8_t>() != 0; }
  template <class T>
  T choice(T last) {
    const auto value = number<std::uint8_t>();
    if (value > static_cast<std::uint8_t>(last)) refuse(fmt::format("type {} is unknown", value));
    return static_cast<T>(value);
  }
  std::string text() {
    const auto bytes = take(number<std::uint64_t>(), 1);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  template <class T>
  std::vector<T> list() {
    const auto count = number<std::uint64_t>();
    const auto bytes = take(count, sizeof(T));
    std::vector<T> values(count);
    if (count > 0) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
    return values;
  }
  Column column() {
    switch (choice(AttributeType::kColor)) {
      case AttributeType::kFloat:
        return Column(list<float>());
      case AttributeType::kDouble:
        return Column(list<double>());
      case AttributeType::kInt:
        return Column(list<std::int32_t>());
      case AttributeType::kUint:
        return Column(list<std::uint32_t>());
      case AttributeType::kVector3:
        return Column(list<Eigen::Vector3f>());
      case AttributeType::kColor:
        break;
    }
    return Column(list<Rgba8>());
  }
  bool isAtEnd() const { return left_.empty(); }

 private:
  std::span<const std::byte> take(std::uint64_t count, std::size_t size) {
    if (count > left_.size() / size) refuse("it ends too early");
    const auto taken = left_.first(count * size);
    left_ = left_.subspan(taken.size());
    return taken;
  }

  std::span<const std::byte> left_;
};

bool ascendBelow(std::span<const Index> rows, Index end) {
  return std::ranges::adjacent_find(rows, std::greater_equal<>()) == rows.end() &&
         (rows.empty() || rows.back() < end);
}

void insertOnce(std::set<std::string>& names, const std::string& name) {
  if (!names.insert(name).second) refuse(fmt::format("attribute '{}' occurs twice", name));
}

}  // namespace

/// The parts of an edit, in the order in which they stand.
class EditBytes {
 public:
  static std::vector<std::byte> format(const Edit& edit);
  static Edit parse(ByteReader bytes, EditWriter writer);

 private:
  static void checkRows(const Edit& edit);
  static void checkPatches(const Edit& edit);
  static void checkNames(const Edit& edit);
  static void checkWhole(const Edit& edit);
};

std::vector<std::byte> EditBytes::format(const Edit& edit) {
  ByteWriter bytes;
  bytes.reserve(edit.memoryBytes());
  bytes.number(kFormat);
  bytes.number(std::uint8_t{edit.applied_});
  bytes.number(edit.kept_);
  bytes.number(edit.appended_);
  bytes.number(edit.topologyId_);
  bytes.list(*edit.removed_);
  bytes.number(std::uint8_t{edit.positions_.has_value()});
  if (edit.positions_) bytes.column(*edit.positions_);
  bytes.number(static_cast<std::uint32_t>(edit.patches_.size()));
  for (const Edit::Patch& patch : edit.patches_) {
    bytes.text(patch.name);
    bytes.list(*patch.rows);
    bytes.column(patch.values);
    bytes.column(patch.ends);
  }
  bytes.number(static_cast<std::uint32_t>(edit.held_.size()));
  for (const auto& [attribute, position] : edit.held_) {
    bytes.text(attribute.name);
    bytes.text(attribute.file.name);
    bytes.number(static_cast<std::uint8_t>(attribute.file.type));
    bytes.number(std::uint8_t{attribute.file.hasAlpha});
    bytes.column(attribute.column);
    bytes.number(std::uint64_t{position});
  }
  bytes.number(static_cast<std::uint32_t>(edit.leaving_.size()));
  for (const std::string& name : edit.leaving_) bytes.text(name);
  bytes.number(std::uint8_t{edit.triangles_ != nullptr});
  if (edit.triangles_) bytes.list(*edit.triangles_);
  return bytes.take();
}

Edit EditBytes::parse(ByteReader bytes, EditWriter writer) {
  Edit edit;
  if (bytes.number<std::uint32_t>() != kFormat) refuse("it begins otherwise");
  edit.applied_ = bytes.flag();
  edit.kept_ = bytes.number<Index>();
  edit.appended_ = bytes.number<Index>();
  edit.topologyId_ = bytes.number<ColumnId>();
  edit.removed_ = std::make_shared<std::vector<Index>>(bytes.list<Index>());
  if (writer == EditWriter::kAnotherProgram && edit.changesRows()) edit.topologyId_ = newColumnId();
  if (bytes.flag()) edit.positions_ = bytes.column();
  for (auto count = bytes.number<std::uint32_t>(); count > 0; --count) {
    edit.patches_.push_back({.name = bytes.text(),
                             .rows = std::make_shared<std::vector<Index>>(bytes.list<Index>()),
                             .values = bytes.column(),
                             .ends = bytes.column()});
  }
  for (auto count = bytes.number<std::uint32_t>(); count > 0; --count) {
    Attribute attribute{.name = bytes.text(), .column = {}, .file = {.name = bytes.text()}};
    attribute.file.type = bytes.choice(ScalarType::kFloat64);
    attribute.file.hasAlpha = bytes.flag();
    attribute.column = bytes.column();
    edit.held_.push_back({std::move(attribute), bytes.number<std::uint64_t>()});
  }
  for (auto count = bytes.number<std::uint32_t>(); count > 0; --count) edit.leaving_.push_back(bytes.text());
  if (bytes.flag()) edit.triangles_ = std::make_shared<std::vector<Triangle>>(bytes.list<Triangle>());
  if (!bytes.isAtEnd()) refuse("something follows it");
  checkRows(edit);
  checkPatches(edit);
  checkNames(edit);
  checkWhole(edit);
  return edit;
}

void EditBytes::checkRows(const Edit& edit) {
  constexpr std::uint64_t kMost = std::numeric_limits<Index>::max();
  if (edit.kept_ + std::uint64_t{edit.removed_->size()} > kMost ||
      edit.kept_ + std::uint64_t{edit.appended_} > kMost) {
    refuse("it has too many rows");
  }
  if (!ascendBelow(*edit.removed_, edit.sizeBefore())) refuse("its removed rows do not ascend");
}

// Each patch has a value a row, and the rows that only the other side has at the end.
void EditBytes::checkPatches(const Edit& edit) {
  const std::size_t ends = edit.applied_ ? edit.removed_->size() : edit.appended_;
  for (const Edit::Patch& patch : edit.patches_) {
    if (!ascendBelow(*patch.rows, edit.kept_)) refuse("the rows of a patch do not ascend");
    if (patch.values.size() != patch.rows->size()) refuse("a patch has another number of values than rows");
    if (patch.ends.type() != patch.values.type()) refuse("a patch is of two types");
    if (patch.ends.size() != ends) refuse("a patch lacks rows");
    if (patch.name.empty() && patch.values.type() != AttributeType::kVector3)
      refuse("positions are no vectors");
  }
}

void EditBytes::checkNames(const Edit& edit) {
  std::set<std::string> patched, held, leaving;
  for (const Edit::Patch& patch : edit.patches_) insertOnce(patched, patch.name);
  for (const Edit::Held& one : edit.held_) {
    insertOnce(held, one.attribute.name);
    if (patched.contains(one.attribute.name)) refuse("an attribute is patched and held");
  }
  for (const std::string& name : edit.leaving_) {
    insertOnce(leaving, name);
    if (patched.contains(name)) refuse("an attribute is patched and leaves");
  }
}

// Whole columns and triangles are those of the other side.
void EditBytes::checkWhole(const Edit& edit) {
  const Index size = edit.applied_ ? edit.sizeBefore() : edit.sizeAfter();
  const bool patchesPositions =
      std::ranges::find(edit.patches_, "", &Edit::Patch::name) != edit.patches_.end();
  if (edit.positions_ && patchesPositions) refuse("it has positions twice");
  if (edit.changesRows() && !(edit.positions_ || patchesPositions)) refuse("it lacks positions");
  if (edit.changesRows() && !edit.triangles_) refuse("it lacks triangles");
  if (edit.positions_ &&
      (edit.positions_->type() != AttributeType::kVector3 || edit.positions_->size() != size)) {
    refuse("its positions are not those of its points");
  }
  for (const Edit::Held& held : edit.held_) {
    if (held.attribute.column.size() != size) refuse("an attribute has another length than its points");
  }
  if (!std::ranges::is_sorted(edit.held_, {}, &Edit::Held::position)) refuse("its attributes do not ascend");
  if (!edit.triangles_) return;
  for (const Triangle& triangle : *edit.triangles_) {
    if (std::ranges::max(triangle) >= size) refuse("a triangle names a point beyond its points");
  }
}

std::vector<std::byte> formatEdit(const Edit& edit) {
  return EditBytes::format(edit);
}

Edit parseEdit(std::span<const std::byte> bytes, EditWriter writer) {
  return EditBytes::parse(ByteReader(bytes), writer);
}

}  // namespace stipple
