#pragma once
#include <array>
#include <vector>

#include "drape/form.h"

namespace seamwise {

/// A closed surface in space. [cm]
struct Surface {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise, seen from outside
};

/// The surface of these parts of a form: marching tetrahedra on a grid, vertices moved onto the
/// surface to 1e-6 cm, mirrored exactly about x = 0.
/// @param spacing   of the grid, cm
Surface surfaceOf(const Form& form, BodyParts parts, double spacing);

}  // namespace seamwise
