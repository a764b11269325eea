#pragma once
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Splits a simple counter-clockwise polygon into convex counter-clockwise ones. Ears are clipped,
/// then triangles are joined across every diagonal that convexity does not need [Hertel and
/// Mehlhorn 1983]. Each part extends over its diagonals by `overlap`, so that points on diagonals
/// are that deep inside a part, too. [cm]
std::vector<Polyline> convexParts(const Polyline& polygon, double overlap);

/// The Minkowski sum of a convex polygon and the other one rotated by 180 degrees: the forbidden
/// positions of the origin of `b` relative to that of `a`. Both and the sum are counter-clockwise.
Polyline convexDifference(const Polyline& a, const Polyline& b);

}  // namespace seamwise
