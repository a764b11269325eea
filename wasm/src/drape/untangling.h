#pragma once
#include <utility>
#include <vector>

#include "drape/cloth_point.h"
#include "drape/drape_check.h"
#include "drape/sewn_mesh.h"

namespace seamwise {

/// Force on an edge; the triangle that the edge pierces gets the opposite force.
struct CrossingPull {
  ClothPoint on_edge, on_triangle;
  Vec3 force;              ///< N, on the edge
  ClothCrossing crossing;  ///< crossing that the force separates
};

/// Separates sheets of a cloth that cross, regardless of their original sides. It shortens the line
/// along which they cross until none is left (P. Volino, N. Magnenat-Thalmann, "Resolving Surface
/// Collisions through Intersection Contour Minimization", SIGGRAPH 2006). The object keeps a
/// pointer to the mesh.
class Untangling {
 public:
  explicit Untangling(const SewnMesh& mesh);
  /// Returns one pull for each crossing of the cloth at x.
  std::vector<CrossingPull> pulls(const Positions& x) const;

 private:
  /// Triangle beside an edge.
  struct Wing {
    int from, to;  ///< vertices, from < to
    int opposite;
    bool operator<(const Wing& o) const { return std::pair(from, to) < std::pair(o.from, o.to); }
  };
  Vec3 shortening(int from, int to, const Vec3& normal, const Positions& x) const;

  const SewnMesh* mesh_;
  std::vector<Wing> wings_;  ///< sorted
};

}  // namespace seamwise
