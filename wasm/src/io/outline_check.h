#pragma once
#include <cstddef>
#include <vector>

#include "geometry/curve.h"
#include "io/json_input.h"
#include "pattern/garment.h"

namespace seamwise {

/// The corners of a polygon that approximates a closed loop of curves within 1e-3 cm. [cm]
Polyline asPolygon(const std::vector<Curve>& loop);

/// Area inside a closed loop of curves, positive if it runs counter-clockwise. [cm^2]
double signedArea(const std::vector<Curve>& loop);

/// Fails with kOutlineSelfIntersects if the loop encloses no area, or crosses or touches itself.
/// The message contains the position (cm, in the frame of `loop`) and the two edges.
void checkOutline(const std::vector<Curve>& loop, const Place& place);

/// Fails with kOutlineSelfIntersects if hole `h` is not strictly inside the panel's outline or
/// overlaps or touches one of the holes before it.
void checkHole(const Panel& panel, std::size_t h, const Place& place);

}  // namespace seamwise
