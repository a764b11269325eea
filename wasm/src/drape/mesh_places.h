#pragma once
#include <vector>

#include "drape/sewn_mesh.h"

namespace seamwise {

/// Finds points in the mesh of one piece; keeps a pointer to it. The triangles are binned by a
/// square grid, so that a search looks at a few of them.
class MeshPlaces {
 public:
  explicit MeshPlaces(const Piece& piece);
  /// The triangle that p lies in, or else the one it is beside.
  MeshPlace at(const Vec2& p) const;

 private:
  int columnOf(double x) const;
  int rowOf(double y) const;
  /// Least distance of p from the lines of the edges, negative outside; with the weights. [cm]
  double depthIn(int triangle, const Vec2& p, std::array<double, 3>& weights) const;

  const Piece* piece_;
  Vec2 low_ = Vec2::Zero();
  double cell_ = 1;  ///< cm
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<int>> cells_;  ///< triangles whose boxes reach into a cell
};

}  // namespace seamwise
