#pragma once
#include <optional>
#include <vector>

#include "drape/sewn_mesh.h"

namespace seamwise {

/// Half of a cloth that is its own mirror image in the plane x = 0. Draping only the half costs
/// half as much and keeps the whole symmetric to the last bit.
struct HalfCloth {
  SewnMesh mesh;             ///< renumbered vertices; includes hinges across the plane
  std::vector<int> vertex;   ///< per half vertex: index in the whole cloth
  std::vector<int> image;    ///< per half vertex: index of its mirror image in the whole cloth
  std::vector<int> in_half;  ///< per vertex of the whole cloth: index in the half, or -1

  bool inPlane(int i) const { return vertex[i] == image[i]; }
  Positions whole(const Positions& half) const;
  Positions half(const Positions& whole) const;
};

/// Returns one half of a cloth. The result is empty if the cut or the positions are not symmetric,
/// or if triangles cross the plane.
/// @param image   per vertex: its mirror image; or empty
/// @param x       positions, m; the half further towards +x is returned
std::optional<HalfCloth> halved(const SewnMesh& mesh, const std::vector<int>& image,
                                const Positions& x);

}  // namespace seamwise
