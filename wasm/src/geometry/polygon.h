#pragma once
#include <optional>
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Area of the closed polygon p[0], ..., p[n-1], positive when counter-clockwise. [cm^2]
double signedArea(const Polyline& closed);

/// A forbidden contact of two edges of closed loops.
struct Crossing {
  int first_loop = 0, first_edge = 0;  ///< edge k joins vertices k and k + 1 of its loop
  int second_loop = 0, second_edge = 0;
  Vec2 at = Vec2::Zero();  ///< cm
};

/// Finds the first place where closed loops cross or touch themselves or each other, or nothing if
/// all are simple and apart. Consecutive edges may share their vertex, but not fold back. A grid of
/// the edges keeps the time about linear for outlines.
std::optional<Crossing> findCrossing(const std::vector<Polyline>& loops);
std::optional<Crossing> findCrossing(const Polyline& closed);

/// Returns whether p is inside the closed polygon (even-odd); a point on the outline may go either
/// way.
bool contains(const Polyline& closed, const Vec2& p);

/// The point of a polyline nearest to p.
struct Nearest {
  int segment = -1;  ///< between vertices segment and segment + 1; -1: the line has no segment
  double along = 0;  ///< fraction along that segment, in [0, 1]
  Vec2 point = Vec2::Zero();
  double distance = 0;  ///< cm
};
Nearest nearestOnPolyline(const Polyline& line, const Vec2& p);

}  // namespace seamwise
