#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/document/document.h"
#include "app/view/frame_maker.h"
#include "app/view/look.h"

namespace stipple {

/// Tells what to show anew when a document, or the state of a running process, is another than before.
class DisplayFollower {
 public:
  const Look& look() const { return look_; }
  const PointColors& colors() const { return colors_; }

  /// Everything, for the first time or because another look is wanted. A look that names attributes that the
  /// points lack is that of their own color.
  SceneChange show(const PointSet& points, const Look& look);
  SceneChange restyle(const PointSet& points, const Look& look);
  /// What changed; nothing where it cannot be seen.
  std::optional<SceneChange> follow(const PointSet& points, const DocumentChange& change);
  /// A state with the same rows that is shown for a while (a running process), or the document again after
  /// it. Nothing where rows differ from what is shown.
  std::optional<SceneChange> preview(const PointSet& points);

 private:
  Look fitting(const PointSet& points, Look look) const;
  Restate restate(const PointSet& points, bool moved);
  bool shows(const std::string& column) const;
  bool moved(const PointSet& points) const;
  std::string marked() const;
  void remember(const PointSet& points);

  Look wanted_, look_;
  PointColors colors_;
  std::uint64_t surface_ = 0;
  ColumnId positions_ = 0, normals_ = 0, displayNormals_ = 0;
  Index size_ = 0;
};

}  // namespace stipple
