#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/points/edit.h"

namespace stipple {

/// What changed between two revisions of a document.
struct DocumentChange {
  bool everything = false;                  ///< rows came or went, or too much has happened to list it
  bool triangles = false;                   ///< others, on the same rows
  std::vector<Edit::Touched> columns = {};  ///< each named once
};

DocumentChange changeOf(const Edit& edit);

/// What changed at each of the last revisions; of older ones it says "everything". Takes little memory.
class ChangeLog {
 public:
  std::uint64_t revision() const { return revision_; }
  /// The revision grows by one.
  void add(DocumentChange change);
  DocumentChange since(std::uint64_t revision) const;

 private:
  struct Entry {
    DocumentChange change;
    std::size_t rows;
  };

  std::uint64_t revision_ = 1;
  std::deque<Entry> entries_;  // the last one led to revision_
  std::size_t rows_ = 0;       // in all entries
};

}  // namespace stipple
