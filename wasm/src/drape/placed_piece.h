#pragma once
#include "drape/vectors.h"
#include "geometry/vec2.h"

namespace seamwise {

/// Placement of a piece: maps face-up coordinates to the body's, cm.
struct PlacedPiece {
  Vec3 right, up;  ///< unit vectors along x and y of the piece
  Vec3 shift;      ///< cm
  Vec3 operator()(const Vec2& p) const { return right * p.x() + up * p.y() + shift; }
};

}  // namespace seamwise
