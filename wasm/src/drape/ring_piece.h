#pragma once
#include <vector>

#include "pattern/pattern.h"

namespace seamwise {

/// A piece laid out for a ring: its vertices by (across, level), across to the right as seen from
/// outside, both in cm, levels along the tube's axis.
struct RingPiece {
  int piece = -1;
  double angle = 0;        ///< of its middle about the axis, degrees from the front, to the left
  std::vector<Vec2> flat;  ///< per vertex
  const Piece* outline = nullptr;

  /// Where the ring's seams run down a side: sewn to its neighbour between these levels.
  struct Flank {
    double low = 1e9, high = -1e9;
    bool sewn() const { return low <= high; }
    /// Below a slit or a curved hem the ring goes on; above an armhole it does not.
    bool covers(double level) const { return level <= high + 0.5; }
  };
  Flank left, right;
  double bottom = 0, top = 0;  ///< cm
  bool hem = false;            ///< what hangs lowest of it is an edge that is sewn to nothing
  /// So far from its middle both ends of a band that is tied are folded down, cm; or 0.
  double tied = 0;

  /// Least and greatest `across` at a level, clamped to the piece's own.
  Vec2 extent(double level) const;
  bool isSewnAt(double level) const {
    return (left.sewn() && level > left.low && level < left.high) ||
           (right.sewn() && level > right.low && level < right.high);
  }
  bool inRing() const { return left.sewn() || right.sewn(); }
  /// A point as it lies once the ends are folded down: how far out from the middle, and its level.
  Vec2 folded(const Vec2& p, double middle) const;
  /// Ends that meet other pieces' ends do not count: tiers lie below each other.
  bool reaches(double level) const { return bottom + 0.3 < level && level < top - 0.3; }
};

/// Finds the flanks and hems of the pieces of a ring, by their seams.
void findFlanks(const Pattern& pattern, std::vector<RingPiece>* pieces);
void findHems(const Pattern& pattern, std::vector<RingPiece>* pieces);

}  // namespace seamwise
