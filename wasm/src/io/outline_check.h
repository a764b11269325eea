#pragma once
#include <cstddef>
#include <vector>

#include "geometry/curve.h"
#include "io/json_input.h"
#include "pattern/garment.h"

namespace seamwise {

/// A closed loop of curves as the corners of a polygon, within 1e-3 cm. [cm]
Polyline asPolygon(const std::vector<Curve>& loop);

/// Area inside a closed loop of curves, positive when it runs counter-clockwise. [cm^2]
double signedArea(const std::vector<Curve>& loop);

/// Fails with kOutlineSelfIntersects when the loop encloses no area, or crosses or touches itself:
/// where (cm, in the frame of `loop`) and between which edges.
void checkOutline(const std::vector<Curve>& loop, const Place& place);

/// Fails with kOutlineSelfIntersects when hole `h` does not lie strictly inside the panel's outline
/// or touches one of the holes before it.
void checkHole(const Panel& panel, std::size_t h, const Place& place);

}  // namespace seamwise
