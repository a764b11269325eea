#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "alignment/model/matching.h"

namespace seamwise {

/// Alignments of one leader: turned by up to `turn` from `at` about the leader's centre, then
/// shifted by up to each of both half sides.
struct Box {
  Alignment at;
  double turn = 0;                                       ///< rad
  std::array<Vec2, 2> half{Vec2::Zero(), Vec2::Zero()};  ///< half sides in print space, cm
  /// The greatest shift. [cm]
  double shift() const { return std::max((half[0] + half[1]).norm(), (half[0] - half[1]).norm()); }
  /// The greatest movement of a point at distance 1 from the centre by the turn.
  double swing() const { return turn > 0 ? 2 * std::sin(std::min(turn, kPi) / 2) : 0; }
};

/// A half of a box, divided across one side: the turn (0) or a shift (1, 2), towards less or more.
struct HalfBox {
  Box box;
  int side;
  int sign;  ///< -1 or 1
};

/// Covers the alignments of a leader by boxes. Angles count modulo the print's rotations, shifts
/// modulo its lattice.
class Boxes {
 public:
  Boxes(const MatchProblem& problem, int leader);

  /// All admissible alignments that put different prints on the leader.
  /// @param first   true for one leader of a problem without pins: it omits the shifts that
  ///                preserve the print's group, which change no cost if all leaders take them
  std::vector<Box> all(bool first) const;
  /// The halves of a box across its widest side, without those that the grain forbids; empty for a
  /// single alignment.
  std::vector<HalfBox> halves(const Box& box) const;
  /// Approximate movement of the leader's matched points in a box. [cm]
  double movement(const Box& box) const { return box.turn * reach_ + box.shift(); }

  int leader() const { return leader_; }
  /// Mean distance of the leader's matched points from its centre. [cm]
  double reach() const { return reach_; }

 private:
  std::vector<Box> onMirrors(bool first) const;
  std::array<Vec2, 2> cell(bool first) const;
  bool neutral(const Vec2& shift) const;

  const MatchProblem& problem_;
  int leader_;
  double reach_ = 0;
};

}  // namespace seamwise
