#pragma once
#include <vector>

#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// One side of a seam with its piece held upright: (across, up), cm.
struct UprightSide {
  int piece;
  Vec2 middle;         ///< mean of its vertices
  Vec2 way;            ///< vector from its first vertex to its last
  Vec2 out;            ///< mean unit vector out of the piece
  double top, bottom;  ///< heights of its highest and lowest vertex
};

/// Seam between two pieces, or of one with itself.
struct UprightJoin {
  UprightSide a, b;
  double length;  ///< distance between the ends of the shorter side, cm
  /// Returns the counter-clockwise quarter turns that align b with a, because bands are often cut
  /// across the grain.
  int quarters() const;
  /// Returns whether the seam joins the tops of both pieces, as shoulder seams do.
  bool isShoulder() const {
    return a.piece != b.piece && a.out.y() > 0.3 && b.out.y() > 0.3 && a.out.dot(b.out) > 0.3;
  }
  /// Returns whether both pieces can be side by side in one plane there, with b turned by
  /// quarters().
  bool isFlat() const;
  /// Returns whether the seam runs up and down on both sides.
  bool isUpright() const;
};

/// Pieces of a pattern held upright: grain up, outside towards the viewer.
class UprightPieces {
 public:
  UprightPieces(const Garment& garment, const Pattern& pattern);

  /// Converts a point of a piece to (across, up), cm.
  Vec2 operator()(int piece, const Vec2& p) const {
    const Vec2& up = ups_[piece];
    return {up.y() * p.x() - up.x() * p.y(), up.x() * p.x() + up.y() * p.y()};
  }
  /// Unit vector of the up direction in a piece.
  const Vec2& up(int piece) const { return ups_[piece]; }
  /// Turns a piece and its joins counter-clockwise by quarter turns.
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
