#pragma once
#include <vector>

#include "drape/sewn_mesh.h"

namespace seamwise {

/// Locates points in the mesh of one piece and keeps a pointer to the piece. A square grid bins the
/// triangles, so that a search examines only a few of them.
class MeshPlaces {
 public:
  explicit MeshPlaces(const Piece& piece);
  /// Returns the triangle that contains p, or else the closest one.
  MeshPlace at(const Vec2& p) const;

 private:
  int columnOf(double x) const;
  int rowOf(double y) const;
  /// Returns the least signed distance of p from the edge lines, negative outside, and the
  /// barycentric weights. [cm]
  double depthIn(int triangle, const Vec2& p, std::array<double, 3>& weights) const;

  const Piece* piece_;
  Vec2 low_ = Vec2::Zero();
  double cell_ = 1;  ///< cm
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<int>> cells_;  ///< triangles whose bounding boxes touch a cell
};

}  // namespace seamwise
