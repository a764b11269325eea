#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "drape/ring_piece.h"
#include "drape/tube.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Ring of pieces wound around a tube of the body. Pieces sewn side by side are adjacent at every
/// level. They close around the tube's section or around a larger curve of the same shape. Much
/// larger rings form waves.
class Ring {
 public:
  /// @param pieces   pieces in a canonical order; the constructor finds their flanks
  /// @param fold     length at which the fabric bends under its weight, 1/6 of a wave, cm; 0: no
  ///                 waves, the ring is as large as its pieces
  Ring(const Tube& tube, const Pattern& pattern, std::vector<RingPiece> pieces, double fold);

  /// Returns the girth of a band whose ends are tied behind the body at a level. [cm]
  static double girthOfTies(const Tube& tube, double level);

  /// Returns the position of a vertex of pieces()[index], moved outwards by `outward`. [cm]
  Vec3 position(int index, int vertex, double outward) const;
  const std::vector<RingPiece>& pieces() const { return pieces_; }
  /// Returns the largest width of closed pieces relative to the girth that they hang around; 0
  /// without waves.
  double fullness() const { return fullness_; }
  /// Returns the levels at which the pieces close the ring, and the ring's width there. The lowest
  /// `without` levels are omitted, and dips of up to three levels are filled. [cm, cm]
  std::vector<std::pair<double, double>> closedWidths(int without) const;

 private:
  struct Level {
    double girth = 0;          ///< ring girth, cm
    double width = 0;          ///< width of the pieces if they close the ring, else 0, cm
    bool spiral = false;       ///< the longest piece goes around more than once
    std::vector<double> turn;  ///< per piece: angle of its middle, degrees
    std::vector<double> middle, stretch;  ///< per piece: across at the middle, cm; arc per width
    std::vector<Vec2> line;   ///< polygon of the ring in the tube's frame, from the front
    std::vector<double> arc;  ///< arc lengths along the line, one more than corners, cm
  };
  /// Finds tied bands.
  /// @returns the lowest level of their ends, cm; 1e9 without any
  double findTies(const Pattern& pattern);
  Level levelAt(double level) const;
  void levelHem();
  void smooth();
  void draw(Level& level, double at);
  Vec2 onLine(const Level& level, double arc) const;
  double hungGirth(double level) const;
  double levelOf(int index) const { return bottom_ + index; }
  /// Returns the index of the level below a height; another level is above it.
  int below(double height) const {
    const int last = static_cast<int>(levels_.size()) - 1;
    return std::clamp(static_cast<int>(std::floor(height - bottom_)), 0, last - 1);
  }

  const Tube& tube_;
  std::vector<RingPiece> pieces_;
  double fold_;
  double bottom_ = 0;
  double fullness_ = 0;
  std::vector<Level> levels_;  ///< 1 cm apart
};

}  // namespace seamwise
