#pragma once
#include <cmath>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

inline constexpr double kCentimetre = 0.01;  ///< m

/// Vertex positions of a cloth, or one force or step per vertex. [m unless stated otherwise]
using Positions = std::vector<Vec3>;

// Products are written out, because Eigen adds in another order where it vectorises. A difference
// in the last digit ends as a fold elsewhere.

inline double dot(const Vec3& a, const Vec3& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}
inline double length(const Vec3& v) { return std::sqrt(dot(v, v)); }
inline double planarLength(const Vec2& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); }

inline Vec3 crossProduct(const Vec3& a, const Vec3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// Mirror image in the body's middle plane x = 0.
inline Vec3 mirrored(const Vec3& v) { return {-v.x(), v.y(), v.z()}; }

inline double dot(const Positions& a, const Positions& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

/// Computes y += factor x.
inline void addScaled(Positions& y, double factor, const Positions& x) {
  for (std::size_t i = 0; i < y.size(); ++i)
    for (int c = 0; c < 3; ++c) y[i][c] += factor * x[i][c];
}

/// Returns factor a b^T.
inline Mat3 outer(double factor, const Vec3& a, const Vec3& b) {
  Mat3 m;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) m(r, c) = factor * a[r] * b[c];
  return m;
}

/// Returns factor times the identity.
inline Mat3 scalar(double factor) {
  Mat3 m = Mat3::Zero();
  for (int c = 0; c < 3; ++c) m(c, c) = factor;
  return m;
}

}  // namespace seamwise
