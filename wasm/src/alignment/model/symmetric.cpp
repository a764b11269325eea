// Alignments that obey a symmetry of the body: Wolff et al. 2019, 3.1 (one piece) and 3.2 (a pair).
//
// Let W(p) = R^T (p - t). A pair p' = S F p + s is symmetric when W' (S F W^-1) is an
// orientation-reversing element (A, a) of the print. That gives R' = S F R A and t' = S F t + s -
// R' a for *any* such element, without special cases by group. The paper's Eqs. (4)-(7) are the
// same rule for w1 on the x-axis, except that its Eq. 5 turns the wrong way for CM and CMM.
#include "alignment/model/symmetric.h"

namespace seamwise {
namespace {

/// The mirrored angle of a pair, a function that is its own inverse: S F R(phi) A with A = R(alpha)
/// diag(1, -1) is a rotation by theta - phi - alpha - pi.
double mirroredAngle(double angle, const RigidMotion& map, const Element& element) {
  return wrapAngle(map.angle - angle - element.angle - kPi);
}

/// The least turn that brings a line at angle `from` onto one at angle `to`, in [-pi/2, pi/2].
double turnOfLine(double from, double to) { return std::remainder(to - from, kPi); }

}  // namespace

Alignment mirrorImage(const Alignment& first, const RigidMotion& map, const Element& element) {
  const double angle = mirroredAngle(first.angle, map, element);
  return {angle, map(first.translation) - rotation(angle) * element.a};
}

Alignment mirrorSource(const Alignment& second, const RigidMotion& map, const Element& element) {
  const Vec2 image = second.translation + rotation(second.angle) * element.a;
  return {mirroredAngle(second.angle, map, element), map.inverse()(image)};
}

Alignment snapToMirror(const Alignment& wanted, const RigidMotion& map, const Vec2& pivot,
                       const WallpaperGroup& group) {
  const double axis = (map.angle - kPi) / 2;  // R(2 psi + pi) F reflects in a line at angle psi
  const Vec2 on_axis = (pivot + map(pivot)) / 2;

  const MirrorFamily* family = nullptr;
  Vec2 direction = Vec2::Zero();  // direction of the mirrors, in print space
  double turn = 0;
  for (const MirrorFamily& f : group.data().mirrors) {
    const Vec2 d = f.direction[0] * group.w1() + f.direction[1] * group.w2();
    const double needed = turnOfLine(directionOf(d) + wanted.angle, axis);
    if (family != nullptr && std::abs(needed) >= std::abs(turn)) continue;
    family = &f;
    direction = d;
    turn = needed;
  }
  if (family == nullptr) return wanted;

  Alignment snapped{wrapAngle(wanted.angle + turn),
                    on_axis + rotation(turn) * (wanted.translation - on_axis)};
  // h . (u, v) of the axis point equals direction x W / det B; it grows by 1 from one lattice line
  // to the next, over the spacing det B / |direction|.
  const double area = cross(group.w1(), group.w2());
  const double line = cross(direction, snapped.toPrint(on_axis)) / area;
  double offset = std::numeric_limits<double>::infinity();
  for (const double constant : family->constants) {
    const double o = std::remainder(line - constant, 1.0);
    if (std::abs(o) < std::abs(offset)) offset = o;
  }
  const Vec2 normal = perp(direction) / direction.squaredNorm();
  snapped.translation += rotation(snapped.angle) * normal * (offset * area);
  return snapped;
}

}  // namespace seamwise
