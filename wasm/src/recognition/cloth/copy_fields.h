#pragma once
#include <vector>

#include "geometry/vec2.h"
#include "recognition/cloth/smooth_field.h"

namespace seamwise {

/// A part of a picture where the print differs from all its other copies: a crease that hides some
/// of it, dirt, another cloth. A rectangle of the picture. [px]
struct DifferingRegion {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
};

/// In what the copies of a cell on a picture differ, beside what they show.
struct CopyFields {
  /// Red, green, blue: natural logarithm of light over its mean.
  SmoothField light;
  /// Along x and y: what the lattice's map shows at p lies at p + shift(p). [px]
  SmoothField shift;
  /// One channel: how much a copy counts, from its sharpness; 0 in differing regions.
  SmoothField weight;
  /// Root mean square of the shift, as a share of the longer of w1 and w2, or of an eighth of what
  /// is seen where that is longer: cloth gives by a share of its length, however small its print.
  double unevenness = 0;
  std::vector<DifferingRegion> regions;
  /// Share of what is seen of the cloth that lies in them.
  double differing = 0;

  /// Unevenness above which the cloth does not lie flat.
  static constexpr double kFlat = 0.015;
};

}  // namespace seamwise
