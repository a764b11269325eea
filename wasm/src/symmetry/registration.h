#pragma once
#include <vector>

#include "symmetry/outline.h"

namespace seamwise {

/// Larger residuals are treated as equally bad. [cm]
inline constexpr double kFarApart = 1e3;

/// A registration of one outline on another: an orientation-reversing rigid motion and its
/// residual.
struct MirrorRegistration {
  RigidMotion map;  ///< `map.mirrored` is true
  double residual =
      0;  ///< greatest distance between either outline and the image of the other. [cm]
};

/// The mirrored rigid motion that maps p to q with the least squared error (Procrustes, closed
/// form). An angle within rounding of a multiple of a quarter turn becomes exact, so that upright
/// axes stay upright.
/// @param single   true: returns the best true reflection, without a glide along its axis
RigidMotion leastSquaresMirror(const std::vector<Vec2>& p, const std::vector<Vec2>& q, bool single);

/// The reflection of a mirrored motion: the same axis without the glide along it.
RigidMotion withoutGlide(RigidMotion motion);

/// Registers the mirrored outline a onto b from a start, by iterative closest points [Besl & McKay
/// 1992], then in closed form on the corresponding corners. The latter is exact for pieces drafted
/// as exact mirror images. a and b are the same object for a piece that is symmetric in itself.
/// @param enough   larger residuals need not be measured exactly. [cm]
MirrorRegistration registerMirror(const Outline& a, const Outline& b, const RigidMotion& start,
                                  double enough = kFarApart);

/// Greatest distance between either outline and the image of the other, corners included. Measuring
/// stops above `enough`. [cm]
double mirrorResidual(const Outline& a, const Outline& b, const RigidMotion& map, double enough);

/// The same measure for maps that carry edges to edges, point by point on the exact curves and thus
/// free of flattening error. Infinity if the edges do not correspond or a panel has holes. [cm]
double edgewiseResidual(const Panel& a, const Panel& b, const RigidMotion& map);

/// Registers the reflection of one edge onto another edge of the same panel; the result has no
/// glide.
RigidMotion registerEdges(const Curve& first, const Curve& second);

/// Greatest distance between the image of one edge and another edge, from the shorter to the
/// longer. [cm]
double edgeResidual(const Curve& first, const Curve& second, const RigidMotion& map);

}  // namespace seamwise
