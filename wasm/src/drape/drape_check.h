#pragma once
#include <array>
#include <string>
#include <vector>

#include "drape/distance.h"
#include "drape/fabric.h"
#include "drape/sewn_mesh.h"

namespace seamwise {

/// What can be measured of a draped garment. Seams meet, as both sides are one vertex.
struct DrapeCheck {
  /// Of a quantity over all triangles.
  struct Spread {
    double median = 0, p99 = 0, most = 0;
  };
  double depth = 0;    ///< m that a vertex or a triangle's middle is inside the body, at most
  Spread tension;      ///< largest principal stretch less 1, where it is above 0
  Spread compression;  ///< 1 less the smallest, likewise
  int crossings = 0;   ///< pairs of an edge and a triangle that it passes through
};

DrapeCheck checkDrape(const SewnMesh& mesh, const Positions& x, const DistanceField& body);

/// What people should know of a drape that no cloth could have, in a sentence; empty of others.
std::string doubtAbout(const DrapeCheck& check, const Fabric& fabric);

/// An edge that passes through a triangle without a common vertex.
struct ClothCrossing {
  std::array<int, 2> edge;  ///< vertices
  int triangle;
};
std::vector<ClothCrossing> crossingsOf(const SewnMesh& mesh, const Positions& x);

}  // namespace seamwise
