#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace stipple {

enum class BrushKind { kPaint, kErase, kSmooth };
enum class RadiusUnit { kModel, kPixels };
/// What the pressure of a pen scales.
enum class PressureMapping { kNone, kSize, kStrength };
enum class SymmetryAxis { kNone, kX, kY, kZ };

struct BrushSettings {
  BrushKind kind = BrushKind::kPaint;
  std::string attribute = "color";
  std::vector<double> value = {222, 56, 32};  ///< as Stroke::value

  RadiusUnit radiusUnit = RadiusUnit::kPixels;
  double radius = 1;     ///< model units, > 0
  double radiusPx = 40;  ///< pixels of the picture; becomes a length where a stroke begins, for all of it
  double strength = 1;   ///< in (0, 1]
  PressureMapping pressure = PressureMapping::kSize;  ///< a mouse always presses fully
  double spacing = 0.25;                              ///< of dabs along the path, in radii, > 0

  SymmetryAxis symmetry = SymmetryAxis::kNone;
  Eigen::Vector3d symmetryCenter = Eigen::Vector3d::Zero();  ///< on the plane; file coordinates

  /// Leaves out what the picture hides where the stroke begins. Dabs go along the surface and start where it
  /// is seen; this is for thin parts, whose back they would reach. Such strokes depend on the view.
  bool onlyVisible = false;
  std::string within = {};  ///< an attribute; only where it is not 0. Empty: everywhere
};

}  // namespace stipple
