#pragma once
#include <array>

#include "drape/vectors.h"

namespace seamwise {

/// A point of the cloth, by vertices and their weights, sum 1.
struct ClothPoint {
  std::array<int, 3> vertices;
  std::array<double, 3> weights;

  Vec3 at(const Positions& x) const;
  /// y += v at the point, shared among its vertices
  void addTo(Positions& y, const Vec3& v) const;
};

/// Of a triangle, unit; the null vector where it has no area.
Vec3 normalOf(const std::array<int, 3>& triangle, const Positions& x);

/// The foot of a perpendicular from p to the plane of a triangle.
ClothPoint footOf(const Vec3& p, const std::array<int, 3>& triangle, const Positions& x);

}  // namespace seamwise
