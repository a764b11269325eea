#pragma once
#include "drape/vectors.h"
#include "geometry/vec2.h"

namespace seamwise {

/// Where a piece hangs in space: face-up coordinates to the body's, cm.
struct PlacedPiece {
  Vec3 right, up;  ///< unit vectors: where x and y of the piece point
  Vec3 shift;      ///< cm
  Vec3 operator()(const Vec2& p) const { return right * p.x() + up * p.y() + shift; }
};

}  // namespace seamwise
