#include "alignment/model/admissible_alignments.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace seamwise {

Alignment moved(const Alignment& alignment, const Vec2& centre, double turn, const Vec2& shift) {
  const Vec2 print = alignment.toPrint(centre) + shift;
  const double angle = wrapAngle(alignment.angle + turn);
  return {angle, centre - rotation(angle) * print};
}

namespace {

/// Returns whether a rotation of the print carries the line of `from` to a line of `to`, including
/// its sense.
bool samePrint(const AdmissibleAlignments::Place& from, const AdmissibleAlignments::Place& to,
               const WallpaperGroup& group) {
  for (const Element& e : group.elements()) {
    if (e.mirrored || (e.A * from.along - to.along).norm() > 1e-6) continue;
    const double lines = perp(to.along).dot(e(from.on_line) - to.on_line) / to.spacing;
    if (std::abs(lines - std::round(lines)) < 1e-6) return true;
  }
  return false;
}

}  // namespace

AdmissibleAlignments AdmissibleAlignments::pinned(const Alignment& at) {
  AdmissibleAlignments f;
  f.pinned_ = true;
  f.pin_ = at;
  return f;
}

AdmissibleAlignments AdmissibleAlignments::mirrored(const RigidMotion& map,
                                                    const WallpaperGroup& group) {
  AdmissibleAlignments f;
  const double axis = (map.angle - kPi) / 2;  // R(2 axis + pi) F is the reflection at that axis
  f.axis_direction_ = unit(axis);
  f.axis_point_ = map.shift / 2;
  const Mat2 lattice = (Mat2() << group.w1(), group.w2()).finished();
  for (const MirrorFamily& family : group.data().mirrors) {
    const Vec2 d(family.direction[0], family.direction[1]);
    const Vec2 v = lattice * d, normal = perp(v).normalized();
    const Vec2 h(-d.y(), d.x());
    // h . (u,v) grows by det / |v| per cm along the normal
    const double spacing = lattice.determinant() / v.norm();
    for (double constant : family.constants) {
      for (int sense = 0; sense < 2; ++sense) {
        const Vec2 along = sense == 0 ? Vec2(v.normalized()) : Vec2(-v.normalized());
        const double psi = directionOf(along);
        const Place place{wrapAngle(axis - psi), normal * (constant * spacing), along, v.norm(),
                          spacing};
        f.places_.push_back(place);
        const bool known = std::any_of(f.distinct_.begin(), f.distinct_.end(),
                                       [&](const Place& p) { return samePrint(p, place, group); });
        if (!known) f.distinct_.push_back(place);
      }
    }
  }
  return f;
}

bool AdmissibleAlignments::restrictAngles(const std::vector<double>& angles, double tolerance) {
  if (pinned_) return true;
  if (!places_.empty()) {
    std::vector<Place> kept;
    for (const Place& place : places_)
      for (double angle : angles)
        if (std::abs(wrapAngle(place.angle - angle)) <= tolerance + 1e-6) {
          kept.push_back(place);
          break;
        }
    if (kept.empty()) return false;
    places_ = distinct_ = std::move(kept);
    return true;
  }
  angles_ = angles;
  tolerance_ = tolerance;
  return true;
}

Alignment AdmissibleAlignments::onPlace(const Place& place, const Vec2& centre,
                                        double slide) const {
  const Vec2 foot = axis_point_ + axis_direction_ * axis_direction_.dot(centre - axis_point_);
  const Vec2 print = place.on_line + place.along * slide;
  return {place.angle, foot - rotation(place.angle) * print};
}

Alignment AdmissibleAlignments::nearest(const Alignment& wanted, const Vec2& centre) const {
  if (pinned_) return pin_;
  if (!places_.empty()) {
    const Vec2 foot = axis_point_ + axis_direction_ * axis_direction_.dot(centre - axis_point_);
    double least_turn = std::numeric_limits<double>::infinity(), least_shift = least_turn;
    const Place* best = nullptr;
    double best_slide = 0, best_lines = 0;
    for (const Place& place : places_) {
      const double turn = std::abs(wrapAngle(place.angle - wanted.angle));
      if (turn > least_turn + 1e-9) continue;
      const Vec2 off = wanted.toPrint(foot) - place.on_line, normal = perp(place.along);
      const double lines = std::round(off.dot(normal) / place.spacing);
      const double shift = std::abs(off.dot(normal) - lines * place.spacing);
      if (turn < least_turn - 1e-9 || shift < least_shift) {
        least_turn = turn, least_shift = shift, best = &place;
        best_slide = off.dot(place.along), best_lines = lines;
      }
    }
    Place line = *best;
    line.on_line += perp(line.along) * (best_lines * line.spacing);
    return onPlace(line, centre, best_slide);
  }
  if (angles_.empty()) return wanted;
  double turn = std::numeric_limits<double>::infinity();
  for (double angle : angles_) {
    const double full = wrapAngle(angle - wanted.angle);
    const double least = std::copysign(std::max(0.0, std::abs(full) - tolerance_), full);
    if (std::abs(least) < std::abs(turn)) turn = least;
  }
  return moved(wanted, centre, turn, Vec2::Zero());
}

AdmissibleAlignments::Basis AdmissibleAlignments::basis(const Alignment& at) const {
  if (pinned_) return Basis(3, 0);
  if (!places_.empty()) {
    const Vec2 along = rotation(-at.angle) * axis_direction_;
    return Eigen::Vector3d(0, along.x(), along.y());
  }
  if (!mayRotate()) return Basis::Identity(3, 3).rightCols(2);
  return Basis::Identity(3, 3);
}

}  // namespace seamwise
