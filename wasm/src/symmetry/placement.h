#pragma once
#include <vector>

#include "symmetry/outline.h"

namespace seamwise {

/// How well piece maps agree with the body's mirror plane x = 0, by where the pieces hang in 3D.
class Placement {
 public:
  explicit Placement(const Garment& garment);

  /// False when every piece has the same placement, as in files that carry none.
  bool known() const { return known_; }
  /// Root mean square distance between the 3D mirror image of piece `from` and its image on piece
  /// `to`. Zero when not known. [cm]
  double disagreement(int from, int to, const RigidMotion& map, const Outline& outline) const;

 private:
  const Garment& garment_;
  bool known_ = false;
  std::vector<Eigen::Matrix3d> turns_;
};

}  // namespace seamwise
