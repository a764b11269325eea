#pragma once
#include <cmath>

#include "geometry/vec2.h"

namespace seamwise {

// Sums in the order of coordinates, on every platform: Eigen's own depend on what it vectorises.

inline double dot(const Vec3& a, const Vec3& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

inline double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

inline double length(const Vec2& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y()); }

inline Vec3 crossProduct(const Vec3& a, const Vec3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

/// The image in the body's middle plane x = 0.
inline Vec3 mirrored(const Vec3& v) { return {-v.x(), v.y(), v.z()}; }

}  // namespace seamwise
