#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "plugins/api/operator.h"

namespace stipple {

/// The operators at hand, by id. Ids are unique.
class Registry {
 public:
  /// Throws InvalidInput, changing nothing, where the description contradicts itself or the id is taken.
  void add(std::unique_ptr<Operator> added);
  /// Takes all operators of `more`, or throws InvalidInput and takes none.
  void merge(Registry&& more);

  /// Null where there is no such operator.
  const Operator* find(std::string_view id) const;
  /// Sorted by id.
  const std::vector<std::unique_ptr<Operator>>& operators() const { return operators_; }

 private:
  std::vector<std::unique_ptr<Operator>> operators_;
};

}  // namespace stipple
