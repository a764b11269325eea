#pragma once
#include <array>

#include "drape/vectors.h"

namespace seamwise {

/// Point of the cloth as weighted vertices; the weights sum to 1.
struct ClothPoint {
  std::array<int, 3> vertices;
  std::array<double, 3> weights;

  Vec3 at(const Positions& x) const;
  /// Computes y += v at the point, distributed to its vertices.
  void addTo(Positions& y, const Vec3& v) const;
};

/// Returns the unit normal of a triangle, or the null vector for a degenerate triangle.
Vec3 normalOf(const std::array<int, 3>& triangle, const Positions& x);

/// Returns the foot of the perpendicular from p to the plane of a triangle.
ClothPoint footOf(const Vec3& p, const std::array<int, 3>& triangle, const Positions& x);

}  // namespace seamwise
