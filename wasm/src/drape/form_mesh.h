#pragma once
#include <array>
#include <vector>

#include "drape/form.h"

namespace seamwise {

/// Closed surface in space. [cm]
struct Surface {
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise, seen from outside
};

/// Returns the surface of these parts of a form by marching tetrahedra on a grid. Vertices are on
/// the surface to 1e-6 cm, and the mesh is exactly symmetric about x = 0.
/// @param spacing   grid spacing, cm
Surface surfaceOf(const Form& form, BodyParts parts, double spacing);

}  // namespace seamwise
