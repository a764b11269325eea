#pragma once
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Convex polygons, counter-clockwise, whose union is the simple counter-clockwise polygon: ears
/// are clipped, then triangles joined across every diagonal that convexity does not need [Hertel
/// and Mehlhorn 1983]. Each reaches over its diagonals by `overlap`, so that what lies inside of
/// the polygon lies that deep inside of a part, on diagonals too. [cm]
std::vector<Polyline> convexParts(const Polyline& polygon, double overlap);

/// The Minkowski sum of a convex polygon and the other one turned by 180 degrees: where the origin
/// of `b` may not lie against that of `a`. Both and the sum are counter-clockwise.
Polyline convexDifference(const Polyline& a, const Polyline& b);

}  // namespace seamwise
