#pragma once

#include <algorithm>
#include <filesystem>
#include <random>
#include <vector>

#include "app/document/document.h"
#include "app/document/recovery.h"
#include "tests/support/temporary_folder.h"

namespace stipple {

/// The same rows with the same values, whatever a file knows of their names and types beside.
inline bool sameValues(const PointSet& a, const PointSet& b) {
  const auto has = [&](const Attribute& attribute) {
    const Attribute* other = b.find(attribute.name);
    return other && sameBits(attribute.column.values(), other->column.values());
  };
  return a.origin() == b.origin() && a.attributes().size() == b.attributes().size() &&
         sameBits(a.positionColumn().values(), b.positionColumn().values()) &&
         std::ranges::all_of(a.attributes(), has) && a.triangles() == b.triangles();
}

/// A file with a few points and labels.
inline void writeScan(const std::filesystem::path& file, Index size = 30) {
  std::vector<Eigen::Vector3f> positions(size);
  for (Index row = 0; row < size; ++row) positions[row] = {static_cast<float>(row), 1, 2};
  PointSet points(std::move(positions));
  points.set("label", std::vector<std::int32_t>(size, 0));
  Progress progress;
  writePoints(file, points, {}, progress);
}

inline Document openScan(const std::filesystem::path& file) {
  Progress progress;
  return {readPoints(file, progress).points, file};
}

/// One edit, whose kind and values follow from `number`: labels, positions, rows that go or come, attributes.
inline void editOnce(Document& document, std::uint32_t number) {
  std::mt19937 random(number);
  const PointSet& points = document.points();
  PointSet next = points;
  std::vector<Index> removed;
  const auto row = [&] { return static_cast<Index>(random() % points.size()); };
  switch (number % 5) {
    case 0:
      next.set("label", std::vector<std::int32_t>(points.size(), static_cast<std::int32_t>(number)));
      break;
    case 1:
      next.editPositions()[row()] = {static_cast<float>(number), 0, 0};
      break;
    case 2:
      if (points.size() > 5) removed = {row()};
      next.removeRows(removed);
      break;
    case 3:
      next.appendRows(PointSet({{static_cast<float>(number), 5, 5}, {6, 6, 6}}));
      break;
    default:
      if (!next.erase("heat"))
        next.set("heat", std::vector<float>(points.size(), static_cast<float>(number)));
  }
  std::optional<Recipe::Step> step;
  if (number % 2 == 0) step = Stroke{.attribute = "label", .value = {double(number)}, .radius = 1};
  document.commit("Edit " + std::to_string(number), difference(points, next, removed), step);
}

/// What a journal in `folder` leads to.
inline Document recoverFrom(const std::filesystem::path& folder) {
  Progress progress;
  return recoverDocument(findLostWork(folder).at(0), Registry(), progress);
}

/// The only file in a folder.
inline std::filesystem::path fileIn(const std::filesystem::path& folder) {
  return std::filesystem::directory_iterator(folder)->path();
}

/// What would be found if the program that works in `folder` ended now.
inline void copyJournal(const std::filesystem::path& folder, const std::filesystem::path& to) {
  std::filesystem::remove_all(to);
  std::filesystem::create_directories(to);
  std::filesystem::copy_file(fileIn(folder), to / "left.journal");
}

}  // namespace stipple
