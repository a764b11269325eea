#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// Eigenvalues and eigenvectors of a symmetric matrix. Eigen's solver would add 20 kB to a module,
/// and the arctangent 0.5 kB.
struct PrincipalAxes {
  explicit PrincipalAxes(const Mat2& m) {
    const Vec2 uneven((m(0, 0) - m(1, 1)) / 2, m(0, 1));
    const double mean = m.trace() / 2, spread = uneven.norm();
    greater = mean + spread;
    lesser = mean - spread;
    const double x = uneven.x(), y = uneven.y();
    const Vec2 along =
        x >= 0 ? Vec2(x + spread, y) : Vec2(std::abs(y), std::copysign(spread - x, y));
    axis = spread > 0 ? Vec2(along.normalized()) : Vec2::UnitX();
  }
  double greater, lesser;
  Vec2 axis;  ///< eigenvector of `greater`, at half the angle of `uneven`; the other one is
              ///< perpendicular
};

}  // namespace seamwise
