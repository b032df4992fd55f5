#pragma once

#include <Eigen/Core>

#include "plugins/inpainting/hole.h"

namespace stipple {

/// The light on the surface in and around a mask, as far as known colors follow the relief: the shape is
/// known inside the mask, so what hangs on it need not be guessed from the rim. u = s v, log s a linear
/// function of the relief, found by least squares of log v, less a linear trend in space, over what is known
/// around each part of the mask; its values and their differences along edges count (generalized least
/// squares), these the more the farther the paint is alike (maximum likelihood), so that patches of paint are
/// not taken for light. Shrunk to no light at all (s = 1) where colors do not follow the relief by more than
/// chance (James and Stein 1961). Attributes that are not colors have none.
class Shading {
 public:
  explicit Shading(const Hole& hole, const Progress* progress = nullptr);

  /// Colors in linear light (rows are sites) to what they were in even light, and back.
  void takeOff(Eigen::MatrixXd& colors) const;
  void putOn(Eigen::MatrixXd& colors) const;

 private:
  Eigen::MatrixXd factors_;  // s, sites x channels; empty: 1
};

/// Colors are in even light while it lives, however it ends.
class EvenLight {
 public:
  EvenLight(const Shading& shading, Eigen::MatrixXd& colors) : shading_(shading), colors_(colors) {
    shading_.takeOff(colors_);
  }
  ~EvenLight() { shading_.putOn(colors_); }
  EvenLight(const EvenLight&) = delete;
  EvenLight& operator=(const EvenLight&) = delete;

 private:
  const Shading& shading_;
  Eigen::MatrixXd& colors_;
};

}  // namespace stipple
