#pragma once
#include <vector>

#include "geometry/vec2.h"
#include "photo/fabric/smooth_field.h"

namespace seamwise {

/// Part of an image where the print differs from all its other copies, such as a crease that hides
/// some of it, dirt, or another fabric. Rectangle of the image. [px]
struct DifferingRegion {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
};

/// Differences between the copies of a cell in an image, apart from the print.
struct CopyFields {
  /// Red, green, blue: natural logarithm of light over its mean.
  SmoothField light;
  /// Along x and y: content that the lattice's map expects at p is at p + shift(p). [px]
  SmoothField shift;
  /// One channel: weight of a copy by its sharpness; 0 in differing regions.
  SmoothField weight;
  /// Root mean square of the shift, relative to the longer of w1 and w2, or to an eighth of the
  /// visible extent if that is longer. Fabric yields by a share of its length, however small its
  /// print.
  double unevenness = 0;
  std::vector<DifferingRegion> regions;
  /// Share of the visible fabric in these regions.
  double differing = 0;

  /// Unevenness above which the fabric is not flat.
  static constexpr double kFlat = 0.015;
};

}  // namespace seamwise
