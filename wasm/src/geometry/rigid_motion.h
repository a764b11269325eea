#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// A plane motion p -> R(angle) p + shift, or p -> R(angle) F p + shift with F = diag(-1, 1) when
/// `mirrored` (Wolff et al. 2019, Eq. 3). Plain value. Lengths are centimetres, angles radians.
struct RigidMotion {
  double angle = 0.0;         ///< counter-clockwise
  Vec2 shift = Vec2::Zero();  ///< cm
  bool mirrored = false;      ///< true for the orientation-reversing half
  bool operator==(const RigidMotion&) const = default;

  Mat2 linear() const {
    Mat2 m = rotation(angle);
    if (mirrored) m.col(0) = -m.col(0);
    return m;
  }
  Vec2 operator()(const Vec2& p) const { return linear() * p + shift; }

  RigidMotion inverse() const {
    // (R F)^-1 = F R^T = R F, so a mirrored motion keeps its angle.
    RigidMotion m{mirrored ? angle : -angle, Vec2::Zero(), mirrored};
    m.shift = -(m.linear() * shift);
    return m;
  }

  /// The motion that applies `first`, then this one.
  RigidMotion after(const RigidMotion& first) const {
    // F R(a) = R(-a) F
    const double turned = mirrored ? -first.angle : first.angle;
    return {wrapAngle(angle + turned), (*this)(first.shift), mirrored != first.mirrored};
  }

  /// The reflection across the line through a and b.
  static RigidMotion reflection(const Vec2& a, const Vec2& b) {
    // R(2 psi) diag(1,-1) = R(2 psi + pi) F for an axis at angle psi
    const double psi = directionOf(b - a);
    RigidMotion m{wrapAngle(2 * psi + kPi), Vec2::Zero(), true};
    m.shift = a - m.linear() * a;
    return m;
  }
};

/// A rigid motion with a stored matrix, for many points: RigidMotion computes sine and cosine for
/// each point.
struct PointMap {
  Mat2 linear = Mat2::Identity();
  Vec2 shift = Vec2::Zero();

  PointMap() = default;
  explicit PointMap(const RigidMotion& motion) : linear(motion.linear()), shift(motion.shift) {}
  Vec2 operator()(const Vec2& p) const { return linear * p + shift; }

  PointMap inverse() const {
    PointMap back;
    back.linear = linear.transpose();
    back.shift = -(back.linear * shift);
    return back;
  }
};

}  // namespace seamwise
