#pragma once
#include <vector>

#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// One side of a seam, its piece held upright: (across, up), cm.
struct UprightSide {
  int piece;
  Vec2 middle;         ///< of its vertices
  Vec2 way;            ///< from its first vertex to its last
  Vec2 out;            ///< unit vector out of the piece, on the mean
  double top, bottom;  ///< heights of its highest and lowest vertex
};

/// A seam between two pieces, or of one with itself.
struct UprightJoin {
  UprightSide a, b;
  double length;  ///< of the shorter way from end to end, cm
  /// Quarter turns, counter-clockwise, by which b lies along a: bands are often cut across.
  int quarters() const;
  /// Whether it joins the tops of both pieces, as shoulder seams do.
  bool isShoulder() const {
    return a.piece != b.piece && a.out.y() > 0.3 && b.out.y() > 0.3 && a.out.dot(b.out) > 0.3;
  }
  /// Whether both pieces can lie side by side there in one plane, b turned by these quarters.
  bool isFlat() const;
  /// Whether it runs up and down on both sides.
  bool isUpright() const;
};

/// The pieces of a pattern held upright, their grain up and outside towards us.
class UprightPieces {
 public:
  UprightPieces(const Garment& garment, const Pattern& pattern);

  /// A point of a piece: (across, up), cm.
  Vec2 operator()(int piece, const Vec2& p) const {
    const Vec2& up = ups_[piece];
    return {up.y() * p.x() - up.x() * p.y(), up.x() * p.x() + up.y() * p.y()};
  }
  /// Where up is in a piece: a unit vector.
  const Vec2& up(int piece) const { return ups_[piece]; }
  /// Turns a piece by quarters, counter-clockwise, and its joins with it.
  void turn(int piece, int quarters);
  const std::vector<UprightJoin>& joins() const { return joins_; }
  double width(int piece) const;
  double area(int piece) const;

 private:
  UprightSide side(const SeamSide& side) const;
  void join();

  const Pattern& pattern_;
  std::vector<Vec2> ups_;
  std::vector<UprightJoin> joins_;
};

}  // namespace seamwise
