#pragma once
#include <optional>
#include <vector>

#include "drape/sewn_mesh.h"

namespace seamwise {

/// One half of a cloth that is its own image in the plane x = 0: draped alone it costs half, and
/// the whole is symmetric to the last bit.
struct HalfCloth {
  SewnMesh mesh;             ///< its vertices numbered anew; hinges across the plane included
  std::vector<int> vertex;   ///< per vertex of the half its number in the whole
  std::vector<int> image;    ///< per vertex of the half that of its image in the whole
  std::vector<int> in_half;  ///< per vertex of the whole its number in the half, or -1

  bool inPlane(int i) const { return vertex[i] == image[i]; }
  Positions whole(const Positions& half) const;
  Positions half(const Positions& whole) const;
};

/// The half of a cloth, or nothing when the cloth, as cut or as it lies, is not symmetric, or when
/// triangles lie across the plane.
/// @param image   per vertex its image, or empty
/// @param x       where the cloth lies; of two halves that one is taken which lies further to +x
std::optional<HalfCloth> halved(const SewnMesh& mesh, const std::vector<int>& image,
                                const Positions& x);

}  // namespace seamwise
