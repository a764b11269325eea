#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// Signed distance of points from the body under the cloth. y points up. [m]
class DistanceField {
 public:
  virtual ~DistanceField() = default;
  /// Returns the distance, negative inside.
  /// @param gradient   receives the derivative unless null: a vector of about unit length, pointing
  ///                   outwards
  virtual double distance(const Vec3& p, Vec3* gradient) const = 0;
};

}  // namespace seamwise
