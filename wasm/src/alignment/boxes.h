#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "alignment/matching.h"

namespace seamwise {

/// Alignments of one leader: turned by up to `turn` from `at` about the leader's centre, then
/// shifted by up to each of both halves.
struct Box {
  Alignment at;
  double turn = 0;                                       ///< rad
  std::array<Vec2, 2> half{Vec2::Zero(), Vec2::Zero()};  ///< in print space, cm
  bool open = false;          ///< stands for all ways to lie, which are its children
  std::vector<int> children;  ///< empty before it is split
  /// The greatest shift. [cm]
  double shift() const { return std::max((half[0] + half[1]).norm(), (half[0] - half[1]).norm()); }
  /// The greatest way of a point at distance 1 under the turn.
  double swing() const { return 2 * std::sin(std::min(turn, kPi) / 2); }
};

/// All admissible alignments of a leader that put different prints on it, as a tree of boxes.
/// Angles count modulo the print's rotations, shifts modulo its lattice.
class Boxes {
 public:
  /// @param first   the one leader of a problem without pins which alone does not take those shifts
  ///                that leave the print's group as it is: they change no cost when all take them
  Boxes(const MatchProblem& problem, int leader, bool first);

  int leader() const { return leader_; }
  /// Mean distance of the leader's matched points from its centre. [cm]
  double reach() const { return reach_; }
  const Box& operator[](int box) const { return boxes_[box]; }  ///< 0 is the root
  /// The children of a box: halves across its widest side, without those that the grain forbids.
  const std::vector<int>& split(int box);
  /// How often a box has to be halved until no point moves by more than `fine` cm, about.
  double effort(int box, double fine) const;

 private:
  void add(int parent, const Alignment& at, double turn, const std::array<Vec2, 2>& half);
  void addPlaces(bool first);
  std::array<Vec2, 2> cell(bool first) const;
  bool neutral(const Vec2& shift) const;

  const MatchProblem& problem_;
  int leader_;
  double reach_ = 0;
  std::vector<Box> boxes_;
};

}  // namespace seamwise
