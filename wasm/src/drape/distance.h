#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// How far a point is outside a body that cloth lies on. y points up. [m]
class DistanceField {
 public:
  virtual ~DistanceField() = default;
  /// Negative inside.
  /// @param gradient   where not null, is set to the derivative: about a unit vector, outwards
  virtual double distance(const Vec3& p, Vec3* gradient) const = 0;
};

}  // namespace seamwise
