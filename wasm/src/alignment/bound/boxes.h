#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "alignment/model/matching.h"

namespace seamwise {

/// Alignments of one leader: turned by up to `turn` from `at` about the leader's centre, then
/// shifted by up to each of both halves.
struct Box {
  Alignment at;
  double turn = 0;                                       ///< rad
  std::array<Vec2, 2> half{Vec2::Zero(), Vec2::Zero()};  ///< in print space, cm
  /// The greatest shift. [cm]
  double shift() const { return std::max((half[0] + half[1]).norm(), (half[0] - half[1]).norm()); }
  /// The greatest way under the turn of a point at distance 1 from the centre.
  double swing() const { return turn > 0 ? 2 * std::sin(std::min(turn, kPi) / 2) : 0; }
};

/// A half of a box, across a side of it: its turn (0) or a shift (1, 2), towards less or more.
struct HalfBox {
  Box box;
  int side;
  int sign;  ///< -1 or 1
};

/// How the alignments of a leader are covered by boxes. Angles count modulo the print's rotations,
/// shifts modulo its lattice.
class Boxes {
 public:
  Boxes(const MatchProblem& problem, int leader);

  /// All admissible alignments that put different prints on the leader.
  /// @param first   the one leader of a problem without pins which alone does not take those shifts
  ///                that leave the print's group as it is: they change no cost when all take them
  std::vector<Box> all(bool first) const;
  /// The halves of a box across its widest side, without those that the grain forbids; nothing for
  /// a single alignment.
  std::vector<HalfBox> halves(const Box& box) const;
  /// How far the leader's matched points move in a box, about. [cm]
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
