#include "app/document/change_log.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace stipple {

namespace {

// 16 MB of rows, and more entries than dabs come between two frames by far.
constexpr std::size_t kMostRows = std::size_t{4} << 20;
constexpr std::size_t kMostEntries = 1024;

using Rows = std::shared_ptr<const std::vector<Index>>;

Rows unite(const Rows& a, const Rows& b) {
  if (!a || !b) return nullptr;
  if (a == b) return a;
  std::vector<Index> both;
  both.reserve(a->size() + b->size());
  std::ranges::set_union(*a, *b, std::back_inserter(both));
  return std::make_shared<const std::vector<Index>>(std::move(both));
}

}  // namespace

DocumentChange changeOf(const Edit& edit) {
  if (edit.changesRows()) return {.everything = true};
  return {.everything = false, .triangles = edit.changesTriangles(), .columns = edit.touched()};
}

void ChangeLog::add(DocumentChange change) {
  std::size_t rows = 0;
  for (Edit::Touched& column : change.columns) {
    if (column.rows && column.rows->size() > kMostRows / 4) column.rows = nullptr;
    if (column.rows) rows += column.rows->size();
  }
  ++revision_;
  entries_.push_back({std::move(change), rows});
  rows_ += rows;
  while (rows_ > kMostRows || entries_.size() > kMostEntries) {
    rows_ -= entries_.front().rows;
    entries_.pop_front();
  }
}

DocumentChange ChangeLog::since(std::uint64_t revision) const {
  if (revision >= revision_) return {};
  const std::uint64_t count = revision_ - revision;
  if (count > entries_.size()) return {.everything = true};
  DocumentChange whole;
  std::map<std::string, Rows> columns;
  for (auto entry = entries_.end() - static_cast<std::ptrdiff_t>(count); entry != entries_.end(); ++entry) {
    if (entry->change.everything) return {.everything = true};
    whole.triangles = whole.triangles || entry->change.triangles;
    for (const Edit::Touched& column : entry->change.columns) {
      const auto [known, isNew] = columns.try_emplace(column.name, column.rows);
      if (!isNew) known->second = unite(known->second, column.rows);
    }
  }
  for (auto& [name, rows] : columns) whole.columns.push_back({name, std::move(rows)});
  return whole;
}

}  // namespace stipple
