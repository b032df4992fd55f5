#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "app/document/document.h"
#include "app/document/surface_distance.h"
#include "app/tools/graph_selection.h"
#include "app/tools/orbit_camera.h"
#include "app/view/display_follower.h"
#include "app/view/displayed_surface.h"

namespace stipple {

/// A document in the window, and how it is looked at.
struct OpenScan {
  OpenScan(PointSet points, std::filesystem::path path, const HistoryOptions& history)
      : document(std::move(points), std::move(path), history), extent(measureExtent(document.points())) {}

  explicit OpenScan(Document held) : document(std::move(held)), extent(measureExtent(document.points())) {}

  Document document;
  QString title;
  bool isSample = false;  ///< saving asks where to
  Extent extent;
  OrbitCamera camera;
  Look look;
  DisplayFollower follower;
  std::uint64_t shownRevision = 0;  ///< of the document, what was last posted to the view
  /// Of the positions of that column; made when a tool first needs it.
  std::shared_ptr<const SurfaceDistance> distance;
  ColumnId distanceOf = 0;
  /// The same for what grows and shrinks selections.
  std::shared_ptr<const NeighborGraph> neighbors;
  ColumnId neighborsOf = 0;

  bool hasDistance() const { return distance && distanceOf == document.points().positionColumn().id(); }
  bool hasNeighbors() const { return neighbors && neighborsOf == document.points().positionColumn().id(); }
};

}  // namespace stipple
