#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// Eigenvalues and eigenvectors of a symmetric matrix. Eigen's solver takes 20 kB of a module.
struct PrincipalAxes {
  explicit PrincipalAxes(const Mat2& m) {
    const Vec2 uneven((m(0, 0) - m(1, 1)) / 2, m(0, 1));
    const double mean = m.trace() / 2, spread = uneven.norm();
    greater = mean + spread;
    lesser = mean - spread;
    axis = unit(directionOf(uneven) / 2);
  }
  double greater, lesser;
  Vec2 axis;  ///< of the greater one; that of the other is perpendicular
};

}  // namespace seamwise
