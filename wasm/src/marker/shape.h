#pragma once
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Tolerance of the outlines of pieces in tables; a smaller overlap counts as touching. [cm]
inline constexpr double kTouching = 2e-3;

/// A rotated outline and the data for its tables of forbidden differences. [cm]
struct Shape {
  Polyline ring;                ///< counter-clockwise, in steps of 2^-20 cm
  std::vector<Polyline> parts;  ///< convex; their union contains the ring and little more
  Vec2 low, high;               ///< bounds of the ring
  Vec2 inner = Vec2::Zero();    ///< a point that is usually well inside the ring
  double area = 0;              ///< cm2

  Vec2 middle() const { return (low + high) / 2; }
};

/// Rounds coordinates to steps of 2^-20 cm, so that platform differences in the last digits of
/// sines do not affect results.
Vec2 rounded(const Vec2& p);
Shape shapeOf(const Polyline& outline, const Mat2& turn);

/// A polygon of few vertices that contains a simple counter-clockwise polygon. Corners that point
/// inwards are omitted, and short edges are replaced by the intersection of their neighbours. The
/// distance from the polygon is at most `most` cm, or `most_inwards` cm where it curves inwards.
Polyline simplifiedOutwards(const Polyline& polygon, double most, double most_inwards);

}  // namespace seamwise
