#pragma once
#include <vector>

#include "geometry/rigid_motion.h"

namespace seamwise {

/// Position of a piece on the print: W(p) = R(angle)^T (p - translation). [rad, cm]
struct Alignment {
  double angle = 0;
  Vec2 translation = Vec2::Zero();
  bool operator==(const Alignment&) const = default;
  /// W(p), from the piece to the print, and its inverse. [cm]
  Vec2 toPrint(const Vec2& p) const { return rotation(-angle) * (p - translation); }
  Vec2 toPiece(const Vec2& w) const { return rotation(angle) * w + translation; }
};

}  // namespace seamwise
