#include "solve/seam_reasons.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "seam/join.h"

namespace seamwise {
namespace {

/// Mean distance of two seam lines after one is mapped by `linear` and shifted to the best fit with
/// the other. [cm]
double apart(const SeamMidpoints& m, const Mat2& linear) {
  double length = 0, total = 0;
  Vec2 mean = Vec2::Zero();
  for (std::size_t i = 0; i < m.x.size(); ++i) {
    length += m.length[i];
    mean += m.length[i] * (m.x[i] - linear * m.y[i]);
  }
  mean /= length;
  for (std::size_t i = 0; i < m.x.size(); ++i)
    total += m.length[i] * (m.x[i] - linear * m.y[i] - mean).norm();
  return total / length;
}

/// The rotation, or with `mirrored` the reflection, that best fits y to x.
Mat2 bestLinear(const SeamMidpoints& m, bool mirrored) {
  double length = 0;
  Vec2 mx = Vec2::Zero(), my = Vec2::Zero();
  for (std::size_t i = 0; i < m.x.size(); ++i) {
    length += m.length[i];
    mx += m.length[i] * m.x[i], my += m.length[i] * m.y[i];
  }
  mx /= length, my /= length;
  double dot = 0, turn = 0;
  for (std::size_t i = 0; i < m.x.size(); ++i) {
    Vec2 y = m.y[i] - my;
    if (mirrored) y.x() = -y.x();
    dot += m.length[i] * y.dot(m.x[i] - mx), turn += m.length[i] * cross(y, m.x[i] - mx);
  }
  Mat2 linear = rotation(std::atan2(turn, dot));
  if (mirrored) linear.col(0) = -linear.col(0);
  return linear;
}

/// Allowed angles of a piece; empty: any.
std::vector<double> anglesOf(const MatchProblem& match, int piece) {
  const MatchProblem::Follow& follow = match.pieces[piece];
  if (follow.mirrored) return follow.angles;
  const AdmissibleAlignments& admissible = match.leaders[follow.leader].admissible;
  if (!admissible.isMirrored()) return admissible.angles();
  std::vector<double> angles;
  for (const AdmissibleAlignments::Place& place : admissible.places())
    angles.push_back(place.angle);
  return angles;
}

/// `linear` turned towards `wanted`, of the same handedness, by at most `most`. [rad]
Mat2 turnedTowards(const Mat2& linear, const Mat2& wanted, double most) {
  const Mat2 turn = wanted * linear.transpose();
  const double angle = std::atan2(turn(1, 0), turn(0, 0));
  return rotation(std::clamp(angle, -most, most)) * linear;
}

bool isLocked(const Pattern& pattern, const SeamSide& side, const std::vector<EdgeRef>& locked) {
  const Piece& piece = pattern.pieces[side.piece];
  const int k = outlineEdge(piece, side.vertices[0], side.vertices[1]);
  const auto next = std::upper_bound(piece.edge_start.begin(), piece.edge_start.end(), k);
  const int edge = static_cast<int>(next - piece.edge_start.begin()) - 1;
  return std::any_of(locked.begin(), locked.end(), [&](const EdgeRef& ref) {
    return ref.piece == side.piece && ref.edge == edge;
  });
}

}  // namespace

SeamObstacle obstacleOf(const Pattern& pattern, const Seam& seam, const MatchProblem& match,
                        const std::vector<EdgeRef>& locked) {
  if (isLocked(pattern, seam.a, locked) || isLocked(pattern, seam.b, locked))
    return {SeamReason::kLocked, 0};
  if (isGathered(seam)) return {SeamReason::kGather, 0};
  const Alignments as_drafted(pattern.pieces.size());
  const SeamMidpoints m = seamMidpoints(seam, restShapes(pattern), as_drafted);
  const auto& elements = match.group.elements();
  bool has[2] = {false, false};
  for (const Element& e : elements)
    if (!e.mirrored || !match.continuous_only) has[e.mirrored] = true;
  const Mat2 best[2] = {bestLinear(m, false), bestLinear(m, true)};
  const double free[2] = {apart(m, best[0]), apart(m, best[1])};
  const double possible = has[1] ? std::min(free[0], free[1]) : free[0];
  if (possible > kSeenMismatch)
    return {free[1] > kSeenMismatch ? SeamReason::kSize : SeamReason::kGroup, possible};
  const std::vector<double> of_a = anglesOf(match, seam.a.piece);
  const std::vector<double> of_b = anglesOf(match, seam.b.piece);
  if (of_a.empty() || of_b.empty()) return {SeamReason::kOthers, 0};
  const auto &a = match.pieces[seam.a.piece], &b = match.pieces[seam.b.piece];
  const double tolerance = match.leaders[a.leader].admissible.tolerance() +
                           match.leaders[b.leader].admissible.tolerance();
  double allowed = std::numeric_limits<double>::infinity();
  for (const double angle_a : of_a)
    for (const double angle_b : of_b)
      for (const Element& e : elements) {
        if (!has[e.mirrored] || (seam.a.piece == seam.b.piece && angle_a != angle_b)) continue;
        // Pieces with one leader turn together, or against each other if one is the mirror image.
        const bool is_fixed = a.leader == b.leader && e.mirrored == (a.mirrored != b.mirrored);
        const Mat2 linear = rotation(angle_a) * e.A * rotation(-angle_b);
        allowed = std::min(
            allowed, apart(m, turnedTowards(linear, best[e.mirrored], is_fixed ? 0 : tolerance)));
      }
  if (allowed > kSeenMismatch) return {SeamReason::kGrain, allowed};
  return {SeamReason::kOthers, 0};
}

}  // namespace seamwise
