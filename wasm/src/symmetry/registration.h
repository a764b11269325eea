#pragma once
#include <vector>

#include "symmetry/outline.h"

namespace seamwise {

/// Residual above which all are treated as equally bad. [cm]
inline constexpr double kFarApart = 1e3;

/// A registration of one outline on another: an orientation-reversing rigid motion, and what it
/// leaves.
struct MirrorRegistration {
  RigidMotion map;  ///< `map.mirrored` is true
  double residual =
      0;  ///< greatest distance between either outline and the image of the other. [cm]
};

/// The mirrored rigid motion that brings p nearest to q in the least-squares sense (Procrustes,
/// closed form). `single`: the nearest true reflection instead, without a glide along its axis. An
/// angle within rounding of a quarter turn becomes one, so that upright axes stay upright.
RigidMotion leastSquaresMirror(const std::vector<Vec2>& p, const std::vector<Vec2>& q, bool single);

/// The reflection in a mirrored motion: the same axis, the glide along it left out.
RigidMotion withoutGlide(RigidMotion motion);

/// Registers the mirrored outline a onto b from a start: iterative closest points [Besl & McKay
/// 1992], then closed form on the corners that correspond, which is exact for pieces drafted as
/// exact mirror images. a and b are the same object for a piece that is symmetric in itself.
/// @param enough   residual beyond which none is measured exactly. [cm]
MirrorRegistration registerMirror(const Outline& a, const Outline& b, const RigidMotion& start,
                                  double enough = kFarApart);

/// Greatest distance between either outline and the image of the other, corners included; the
/// search stops beyond `enough`. [cm]
double mirrorResidual(const Outline& a, const Outline& b, const RigidMotion& map, double enough);

/// The same measure for maps that carry edge to edge, point by point on the exact curves, so that
/// it is free of flattening error; infinity when the edges do not correspond or a panel has holes.
/// [cm]
double edgewiseResidual(const Panel& a, const Panel& b, const RigidMotion& map);

/// One edge reflected and registered onto another edge of the same panel; the result has no glide.
RigidMotion registerEdges(const Curve& first, const Curve& second);

/// Greatest distance between the image of one edge and another edge, the shorter measured on the
/// longer.
double edgeResidual(const Curve& first, const Curve& second, const RigidMotion& map);

}  // namespace seamwise
