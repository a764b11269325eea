#pragma once
#include <utility>
#include <vector>

#include "drape/cloth_point.h"
#include "drape/drape_check.h"
#include "drape/sewn_mesh.h"

namespace seamwise {

/// A force on an edge, and its opposite on the triangle that the edge passes through.
struct CrossingPull {
  ClothPoint on_edge, on_triangle;
  Vec3 force;              ///< N, on the edge
  ClothCrossing crossing;  ///< what it draws apart
};

/// Draws sheets of a cloth that cross apart, whichever sides they came from: the line along which
/// they cross is made shorter until there is none (P. Volino, N. Magnenat-Thalmann, "Resolving
/// Surface Collisions through Intersection Contour Minimization", SIGGRAPH 2006). Keeps a pointer
/// to the mesh.
class Untangling {
 public:
  explicit Untangling(const SewnMesh& mesh);
  /// One for each crossing of the cloth as it lies.
  std::vector<CrossingPull> pulls(const Positions& x) const;

 private:
  /// A triangle beside an edge.
  struct Wing {
    int from, to;  ///< from < to
    int opposite;
    bool operator<(const Wing& o) const { return std::pair(from, to) < std::pair(o.from, o.to); }
  };
  Vec3 shortening(int from, int to, const Vec3& normal, const Positions& x) const;

  const SewnMesh* mesh_;
  std::vector<Wing> wings_;  ///< sorted
};

}  // namespace seamwise
