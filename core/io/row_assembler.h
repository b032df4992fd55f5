#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/io/point_io.h"
#include "core/io/property_plan.h"

namespace stipple {

/// Rows of equal length as they stand in a file.
struct RowLayout {
  std::vector<RowProperty> properties;
  std::size_t rowBytes = 0;
  bool untyped = false;    ///< from text: coordinates count as float unless they need an origin
  bool swapBytes = false;  ///< numbers in the other byte order than this machine's
};

/// Lays the properties one behind the other in the order given.
RowLayout packedLayout(std::vector<RowProperty> properties);

/// Turns the rows of a file into a point set: every format that stores named numbers point by point ends
/// here. Throws InvalidInput where the coordinates lack.
class RowAssembler {
 public:
  RowAssembler(RowLayout layout, Index capacity);
  ~RowAssembler();
  RowAssembler(RowAssembler&&) noexcept;

  const RowLayout& layout() const;
  Index capacity() const;
  /// More room, where the number of rows was not known.
  void grow(Index capacity);
  /// Decodes whole rows; different ranges of rows may be decoded on different threads.
  void decode(std::span<const std::byte> rows, Index firstRow);
  /// The rows decoded as a point set. Rows with a coordinate that is not finite are dropped and counted;
  /// triangles with a corner that is no row are ignored with a warning.
  ReadResult finish(Index rowCount, std::vector<Triangle> triangles = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The common end of all readers: drops rows with coordinates that are not finite, keeps the triangles that
/// are left.
void dropUnusableRows(ReadResult& result, std::vector<Triangle> triangles);

}  // namespace stipple
