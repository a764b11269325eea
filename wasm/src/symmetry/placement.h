#pragma once
#include <vector>

#include "symmetry/outline.h"

namespace seamwise {

/// Compares piece maps with the body's mirror plane x = 0, using the 3D placement of the pieces.
class Placement {
 public:
  explicit Placement(const Garment& garment);

  /// Position on the body of a point of a piece: x to the left, y up, z ahead. [cm]
  Vec3 placed(int piece, const Vec2& p) const;
  /// False if every piece has the same placement, as in files without placements.
  bool known() const { return known_; }
  /// Root mean square distance between the 3D mirror image of piece `from` and its image on piece
  /// `to`. Zero if no placement is known. [cm]
  double disagreement(int from, int to, const RigidMotion& map, const Outline& outline) const;

 private:
  const Garment& garment_;
  bool known_ = false;
  std::vector<Eigen::Matrix3d> turns_;
};

}  // namespace seamwise
