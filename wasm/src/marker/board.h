#pragma once
#include <array>
#include <optional>

#include "geometry/vec2.h"

namespace seamwise {

/// A position, or the difference of two positions, in steps of a board's basis.
struct Dot {
  int i = 0, j = 0;
  bool operator==(const Dot&) const = default;
};
inline Dot operator+(Dot a, Dot b) { return {a.i + b.i, a.j + b.j}; }
inline Dot operator-(Dot a, Dot b) { return {a.i - b.i, a.j - b.j}; }

/// Whole numbers lo..hi; none if hi < lo.
struct DotRun {
  int lo = 0, hi = -1;
  bool empty() const { return hi < lo; }
  int size() const { return hi < lo ? 0 : hi - lo + 1; }
};

/// The lattice of allowed positions of pieces, as rows of dots: dot (i, j) shifts by i along + j
/// up. `along` is perpendicular to the warp if the lattice has such a vector, and `up` leans the
/// least.
struct Board {
  Vec2 along, up;  ///< cm; along.x > 0, up.y > 0
  Vec2 shift(Dot dot) const { return dot.i * along + dot.j * up; }
  /// Converts a vector to steps of the basis, not rounded.
  Vec2 steps(const Vec2& v) const {
    const double area = cross(along, up);
    return {cross(v, up) / area, cross(along, v) / area};
  }
  bool operator==(const Board&) const = default;

  /// The lattice of w1 and w2. If it has vectors shorter than `least`, a sublattice with the
  /// shortest steps of at least that length. [cm]
  static Board ofLattice(const Vec2& w1, const Vec2& w2, double least);
  static Board square(double step) { return {{step, 0}, {0, step}}; }
};

/// Length of the shortest lattice vector along (1, 0), or with `along_warp` along (0, 1); none if
/// it exceeds a few metres. [cm]
std::optional<double> latticePeriod(const Vec2& w1, const Vec2& w2, bool along_warp);

}  // namespace seamwise
