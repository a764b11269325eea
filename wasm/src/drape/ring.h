#pragma once
#include <utility>
#include <vector>

#include "drape/tube.h"
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

  /// Least and greatest `across` at a level, clamped to the piece's own.
  Vec2 extent(double level) const;
  bool isSewnAt(double level) const {
    return (left.sewn() && level > left.low && level < left.high) ||
           (right.sewn() && level > right.low && level < right.high);
  }
  bool inRing() const { return left.sewn() || right.sewn(); }
  /// Ends that meet other pieces' ends do not count: tiers lie below each other.
  bool reaches(double level) const { return bottom + 0.3 < level && level < top - 0.3; }
};

/// How a ring of pieces winds around a tube of the body: what is sewn side by side lies side by
/// side, at every level, and closes around the section or a larger one of the same shape; much
/// larger ones lie in waves.
class Ring {
 public:
  /// @param pieces   in a canonical order; their flanks are found here
  /// @param fold     length at which the fabric bends under its weight, 1/6 of a wave, cm; 0: no
  ///                 waves, the ring is as large as its pieces
  Ring(const Tube& tube, const Pattern& pattern, std::vector<RingPiece> pieces, double fold);

  /// Where a vertex of pieces()[index] lies, so much further out. [cm]
  Vec3 position(int index, int vertex, double outward) const;
  const std::vector<RingPiece>& pieces() const { return pieces_; }
  /// Levels that the pieces close, without so many lowest ones, and how wide they are there,
  /// without dips of three levels. [cm, cm]
  std::vector<std::pair<double, double>> closedWidths(int without) const;

 private:
  struct Level {
    double girth = 0;                     ///< of the ring, cm
    double width = 0;                     ///< of the pieces, when they close it, or 0
    bool spiral = false;                  ///< its longest piece goes around more than once
    std::vector<double> turn;             ///< per piece: where its middle lies, degrees
    std::vector<double> middle, stretch;  ///< per piece: across at the middle, cm; arc per width
    std::vector<Vec2> line;   ///< polygon of the ring in the tube's frame, from the front
    std::vector<double> arc;  ///< along it, one more than corners, cm
  };
  void findFlanks(const Pattern& pattern);
  Level levelAt(double level) const;
  void smooth();
  void draw(Level& level, double at) const;
  Vec2 onLine(const Level& level, double arc) const;
  double hungGirth(double level) const;
  double levelOf(int index) const { return bottom_ + index; }

  const Tube& tube_;
  std::vector<RingPiece> pieces_;
  double fold_;
  double bottom_ = 0;
  std::vector<Level> levels_;  ///< 1 cm apart
};

}  // namespace seamwise
