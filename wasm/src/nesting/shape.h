#pragma once
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// What the outlines of pieces may differ by in tables: what overlaps less counts as touching. [cm]
inline constexpr double kTouching = 2e-3;

/// A turned outline, with what tables of forbidden differences are made of. [cm]
struct Shape {
  Polyline ring;                ///< counter-clockwise, in steps of 2^-20 cm
  std::vector<Polyline> parts;  ///< convex; their union holds the ring, and little more
  Vec2 low, high;               ///< of the ring
  Vec2 inner = Vec2::Zero();    ///< well inside of the ring, as a rule
  double area = 0;              ///< cm2

  Vec2 middle() const { return (low + high) / 2; }
};

/// Coordinates are rounded to steps of 2^-20 cm, so that the last digits of sines, in which
/// platforms differ, decide nothing.
Vec2 rounded(const Vec2& p);
Shape shapeOf(const Polyline& outline, const Mat2& turn);

/// A polygon of few vertices that holds the simple counter-clockwise polygon: corners that point
/// inwards are left out, short edges give way to where their neighbours meet. It leaves the polygon
/// by at most `most` cm, where that curves inwards by `most_inwards`.
Polyline simplifiedOutwards(const Polyline& polygon, double most, double most_inwards);

}  // namespace seamwise
