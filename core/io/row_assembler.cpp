#include "core/io/row_assembler.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>
#include <utility>

#include "core/io/coordinates.h"
#include "core/io/numbers.h"
#include "core/large_pages.h"
#include "core/parallel.h"

namespace stipple {

static_assert(std::endian::native == std::endian::little,
              "readers and writers assume a little-endian machine");

namespace {

template <class T>
T byteSwapped(T value) {
  auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}

template <class Source, class Target, bool kSwap>
void copyNumbers(const std::byte* source, std::size_t sourceStride, std::byte* target,
                 std::size_t targetStride, std::size_t count) {
  for (std::size_t row = 0; row < count; ++row) {
    Source value;
    std::memcpy(&value, source + row * sourceStride, sizeof value);
    if constexpr (kSwap) value = byteSwapped(value);
    const auto converted = static_cast<Target>(value);
    std::memcpy(target + row * targetStride, &converted, sizeof converted);
  }
}

using CopyNumbers = void (*)(const std::byte*, std::size_t, std::byte*, std::size_t, std::size_t);

template <class Target, bool kSwap>
CopyNumbers copierFrom(ScalarType source) {
  switch (source) {
    case ScalarType::kInt8:
      return copyNumbers<std::int8_t, Target, false>;
    case ScalarType::kUint8:
      return copyNumbers<std::uint8_t, Target, false>;
    case ScalarType::kInt16:
      return copyNumbers<std::int16_t, Target, kSwap>;
    case ScalarType::kUint16:
      return copyNumbers<std::uint16_t, Target, kSwap>;
    case ScalarType::kInt32:
      return copyNumbers<std::int32_t, Target, kSwap>;
    case ScalarType::kUint32:
      return copyNumbers<std::uint32_t, Target, kSwap>;
    case ScalarType::kFloat32:
      if constexpr (std::floating_point<Target>) return copyNumbers<float, Target, kSwap>;
      break;
    case ScalarType::kFloat64:
      if constexpr (std::floating_point<Target>) return copyNumbers<double, Target, kSwap>;
      break;
  }
  return nullptr;
}

template <class Target>
CopyNumbers copier(const RowLayout& layout, std::size_t property) {
  const ScalarType type = layout.properties[property].type;
  return layout.swapBytes ? copierFrom<Target, true>(type) : copierFrom<Target, false>(type);
}

// One property on its way to one component of one column.
struct Route {
  CopyNumbers copy;
  std::size_t sourceOffset;
  std::byte* target;
  std::size_t targetStride;
};

// Colors that are not bytes yet, four numbers a row.
using WideColor = Eigen::Array4f;

std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(std::isnan(value) ? 0.0F : value, 0.0F, 255.0F)));
}

}  // namespace

RowLayout packedLayout(std::vector<RowProperty> properties) {
  RowLayout layout{.properties = std::move(properties)};
  for (RowProperty& property : layout.properties) {
    property.offset = layout.rowBytes;
    layout.rowBytes += sizeOf(property.type);
  }
  return layout;
}

struct RowAssembler::State {
  RowLayout layout;
  PropertyPlan plan;
  Index capacity = 0;
  bool wideCoordinates = false;
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3d> coordinates;
  std::vector<AttributeValues> columns;            // one a planned attribute
  std::vector<std::vector<WideColor>> wideColors;  // likewise, empty unless the color is not in bytes
  std::vector<Route> routes;

  void resize(Index rows);
  void route();
  template <class Component, class Value>
  void routeComponents(std::vector<Value>& column, std::span<const std::size_t> sources);
  AttributeValues finishedColumn(std::size_t a, Index rows);
};

void RowAssembler::State::resize(Index rows) {
  capacity = rows;
  if (wideCoordinates) {
    resizeInLargePages(coordinates, rows);
  } else {
    resizeInLargePages(positions, rows);
  }
  for (std::size_t a = 0; a < columns.size(); ++a) {
    const PlannedAttribute& attribute = plan.attributes[a];
    if (attribute.type == AttributeType::kColor && attribute.coding != ColorCoding::kBytes) {
      wideColors[a].resize(rows, WideColor(0, 0, 0, -1));
    } else {
      std::visit([&](auto& column) { resizeInLargePages(column, rows); }, columns[a]);
    }
  }
  route();
}

template <class Component, class Value>
void RowAssembler::State::routeComponents(std::vector<Value>& column, std::span<const std::size_t> sources) {
  auto* first = reinterpret_cast<std::byte*>(column.data());
  for (std::size_t component = 0; component < sources.size(); ++component) {
    const std::size_t source = sources[component];
    routes.push_back({copier<Component>(layout, source), layout.properties[source].offset,
                      first + component * sizeof(Component), sizeof(Value)});
  }
}

void RowAssembler::State::route() {
  routes.clear();
  if (capacity == 0) return;
  if (wideCoordinates) {
    routeComponents<double>(coordinates, plan.position);
  } else {
    routeComponents<float>(positions, plan.position);
  }
  for (std::size_t a = 0; a < columns.size(); ++a) {
    const auto& sources = plan.attributes[a].sources;
    if (!wideColors[a].empty()) {
      routeComponents<float>(wideColors[a], sources);
      continue;
    }
    std::visit(
        [&](auto& column) {
          using Value = typename std::decay_t<decltype(column)>::value_type;
          if constexpr (std::is_same_v<Value, Eigen::Vector3f>)
            routeComponents<float>(column, sources);
          else if constexpr (std::is_same_v<Value, Rgba8>)
            routeComponents<std::uint8_t>(column, sources);
          else
            routeComponents<Value>(column, sources);
        },
        columns[a]);
  }
}

AttributeValues RowAssembler::State::finishedColumn(std::size_t a, Index rows) {
  const PlannedAttribute& attribute = plan.attributes[a];
  if (wideColors[a].empty()) {
    std::visit([&](auto& column) { column.resize(rows); }, columns[a]);
    return std::move(columns[a]);
  }
  const std::vector<WideColor>& wide = wideColors[a];
  float scale = 1, offset = 0;
  if (attribute.coding == ColorCoding::kSphericalHarmonics) {
    scale = 255 * 0.28209479F;  // sqrt(1 / (4 pi)), the harmonic of order 0
    offset = 127.5F;
  } else {
    float largest = 0;
    for (Index row = 0; row < rows; ++row) {
      for (const float value : wide[row]) largest = std::max(largest, std::isfinite(value) ? value : 0.0F);
    }
    const bool real = isFloating(layout.properties[attribute.sources.front()].type);
    if (real && largest <= 1)
      scale = 255;
    else if (largest > 255)
      scale = 255.0F / 65535;
  }
  std::vector<Rgba8> colors(rows);
  const bool hasAlpha = attribute.sources.size() == 4;
  for (Index row = 0; row < rows; ++row) {
    const WideColor bytes = wide[row] * scale + offset;
    colors[row] = {toByte(bytes[0]), toByte(bytes[1]), toByte(bytes[2]),
                   hasAlpha ? toByte(bytes[3]) : std::uint8_t{255}};
  }
  return colors;
}

RowAssembler::RowAssembler(RowLayout layout, Index capacity) : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.plan = planProperties(layout.properties);
  state.layout = std::move(layout);
  // Floats and integers of up to 16 bits are exact in the float column.
  state.wideCoordinates = std::ranges::any_of(state.plan.position, [&](std::size_t p) {
    const ScalarType type = state.layout.properties[p].type;
    return type == ScalarType::kFloat64 || type == ScalarType::kInt32 || type == ScalarType::kUint32;
  });
  state.wideColors.resize(state.plan.attributes.size());
  for (const PlannedAttribute& attribute : state.plan.attributes) {
    switch (attribute.type) {
      case AttributeType::kFloat:
        state.columns.emplace_back(std::vector<float>{});
        break;
      case AttributeType::kDouble:
        state.columns.emplace_back(std::vector<double>{});
        break;
      case AttributeType::kInt:
        state.columns.emplace_back(std::vector<std::int32_t>{});
        break;
      case AttributeType::kUint:
        state.columns.emplace_back(std::vector<std::uint32_t>{});
        break;
      case AttributeType::kVector3:
        state.columns.emplace_back(std::vector<Eigen::Vector3f>{});
        break;
      case AttributeType::kColor:
        state.columns.emplace_back(std::vector<Rgba8>{});
        break;
    }
  }
  state.resize(capacity);
}

RowAssembler::~RowAssembler() = default;
RowAssembler::RowAssembler(RowAssembler&&) noexcept = default;

const RowLayout& RowAssembler::layout() const {
  return state_->layout;
}
Index RowAssembler::capacity() const {
  return state_->capacity;
}
void RowAssembler::grow(Index capacity) {
  state_->resize(std::max(capacity, state_->capacity));
}

void RowAssembler::decode(std::span<const std::byte> rows, Index firstRow) {
  const std::size_t rowBytes = state_->layout.rowBytes;
  constexpr std::size_t kBlock =
      512;  // rows that stay in the first cache while each property passes over them
  const std::size_t count = rows.size() / rowBytes;
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const std::size_t length = std::min(kBlock, count - begin);
    const std::byte* source = rows.data() + begin * rowBytes;
    for (const Route& route : state_->routes) {
      route.copy(source + route.sourceOffset, rowBytes,
                 route.target + (firstRow + begin) * route.targetStride, route.targetStride, length);
    }
  }
}

ReadResult RowAssembler::finish(Index rowCount, std::vector<Triangle> triangles) {
  State& state = *state_;
  ReadResult result;
  if (state.wideCoordinates) {
    state.coordinates.resize(rowCount);
    const Eigen::Vector3d origin = chooseOrigin(state.coordinates);
    const bool single = state.layout.untyped && origin == Eigen::Vector3d::Zero();
    result.points = PointSet(relativeTo(origin, state.coordinates), origin,
                             single ? ScalarType::kFloat32 : ScalarType::kFloat64);
    std::vector<Eigen::Vector3d>().swap(state.coordinates);
  } else {
    state.positions.resize(rowCount);
    result.points = PointSet(std::move(state.positions));
  }
  for (std::size_t a = 0; a < state.columns.size(); ++a) {
    const PlannedAttribute& attribute = state.plan.attributes[a];
    result.points.set(attribute.name, state.finishedColumn(a, rowCount), attribute.file);
  }
  result.warnings = std::move(state.plan.warnings);
  dropUnusableRows(result, std::move(triangles));
  return result;
}

void dropUnusableRows(ReadResult& result, std::vector<Triangle> triangles) {
  const Index rows = result.points.size();
  const std::size_t before = triangles.size();
  std::erase_if(triangles, [&](const Triangle& triangle) {
    return std::ranges::any_of(triangle, [&](Index corner) { return corner >= rows; });
  });
  if (triangles.size() != before) {
    result.warnings.push_back(
        fmt::format("{} triangles name points that do not exist and are ignored", before - triangles.size()));
  }
  if (!triangles.empty()) result.points.setTriangles(std::move(triangles));
  const std::vector<Index> unusable = rowsNotFinite(result.points.positions());
  result.dropped = static_cast<Index>(unusable.size());
  if (unusable.empty()) return;
  if (result.dropped == rows) throw InvalidInput("holds no point with finite coordinates");
  result.points.removeRows(unusable);
  result.warnings.push_back(fmt::format("{} of {} rows have a coordinate that is not finite and are dropped",
                                        result.dropped, rows));
}

}  // namespace stipple
