#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "drape/ring_piece.h"
#include "drape/tube.h"
#include "pattern/pattern.h"

namespace seamwise {

/// How a ring of pieces winds around a tube of the body: what is sewn side by side lies side by
/// side, at every level, and closes around the section or a larger one of the same shape; much
/// larger ones lie in waves.
class Ring {
 public:
  /// @param pieces   in a canonical order; their flanks are found here
  /// @param fold     length at which the fabric bends under its weight, 1/6 of a wave, cm; 0: no
  ///                 waves, the ring is as large as its pieces
  Ring(const Tube& tube, const Pattern& pattern, std::vector<RingPiece> pieces, double fold);

  /// How far around a band goes whose ends are tied behind the body at a level. [cm]
  static double girthOfTies(const Tube& tube, double level);

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
  /// @returns how low their ends hang, cm; or 1e9
  double findTies(const Pattern& pattern);
  Level levelAt(double level) const;
  void levelHem();
  void smooth();
  void draw(Level& level, double at) const;
  Vec2 onLine(const Level& level, double arc) const;
  double hungGirth(double level) const;
  double levelOf(int index) const { return bottom_ + index; }
  /// The level below a height, with one above it.
  int below(double height) const {
    const int last = static_cast<int>(levels_.size()) - 1;
    return std::clamp(static_cast<int>(std::floor(height - bottom_)), 0, last - 1);
  }

  const Tube& tube_;
  std::vector<RingPiece> pieces_;
  double fold_;
  double bottom_ = 0;
  std::vector<Level> levels_;  ///< 1 cm apart
};

}  // namespace seamwise
