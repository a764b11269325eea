#pragma once
#include <vector>

#include "pattern/pattern.h"

namespace seamwise {

/// Flattened piece of a ring: its vertices are (across, level) in cm, across to the right as seen
/// from outside, level along the tube's axis.
struct RingPiece {
  int piece = -1;
  double angle = 0;        ///< degrees from the front towards the left, at its middle
  std::vector<Vec2> flat;  ///< per vertex
  const Piece* outline = nullptr;

  /// Side of a piece along the ring's seams: sewn to its neighbour between these levels.
  struct Flank {
    double low = 1e9, high = -1e9;
    bool sewn() const { return low <= high; }
    /// The ring continues below a slit or a curved hem, but not above an armhole.
    bool covers(double level) const { return level <= high + 0.5; }
  };
  Flank left, right;
  double bottom = 0, top = 0;  ///< cm
  bool hem = false;            ///< an edge at its lowest point has no seam
  /// Distance from the middle at which both ends of a tied band are folded down, cm; 0: not tied.
  double tied = 0;

  /// Minimum and maximum `across` at a level, which is clamped to the piece.
  Vec2 extent(double level) const;
  bool isSewnAt(double level) const {
    return (left.sewn() && level > left.low && level < left.high) ||
           (right.sewn() && level > right.low && level < right.high);
  }
  bool inRing() const { return left.sewn() || right.sewn(); }
  /// Returns a point after the ends are folded down: distance from the middle, and level.
  Vec2 folded(const Vec2& p, double middle) const;
  /// The margin excludes ends that only meet the ends of other pieces, as in tiers.
  bool reaches(double level) const { return bottom + 0.3 < level && level < top - 0.3; }
};

/// Find the flanks and the hems of a ring's pieces by their seams.
void findFlanks(const Pattern& pattern, std::vector<RingPiece>* pieces);
void findHems(const Pattern& pattern, std::vector<RingPiece>* pieces);

}  // namespace seamwise
