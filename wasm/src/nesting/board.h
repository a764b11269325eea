#pragma once
#include <array>
#include <optional>

#include "geometry/vec2.h"

namespace seamwise {

/// A difference of two places in steps of a board's basis, or a place.
struct Dot {
  int i = 0, j = 0;
  bool operator==(const Dot&) const = default;
};
inline Dot operator+(Dot a, Dot b) { return {a.i + b.i, a.j + b.j}; }
inline Dot operator-(Dot a, Dot b) { return {a.i - b.i, a.j - b.j}; }

/// Whole numbers lo..hi; none when hi < lo.
struct DotRun {
  int lo = 0, hi = -1;
  bool empty() const { return hi < lo; }
  int size() const { return hi < lo ? 0 : hi - lo + 1; }
};

/// The lattice of places that pieces may take, as rows of dots: dot (i, j) shifts by i along + j
/// up. `along` lies across the cloth where the lattice has such a vector, and `up` leans the least.
struct Board {
  Vec2 along, up;  ///< cm; along.x > 0, up.y > 0
  Vec2 shift(Dot dot) const { return dot.i * along + dot.j * up; }
  /// In steps of the basis, not rounded.
  Vec2 steps(const Vec2& v) const {
    const double area = cross(along, up);
    return {cross(v, up) / area, cross(along, v) / area};
  }
  bool operator==(const Board&) const = default;

  /// The lattice of w1 and w2, or, where that has vectors shorter than `least`, one of those of its
  /// sublattices whose steps are the shortest that are not. [cm]
  static Board ofLattice(const Vec2& w1, const Vec2& w2, double least);
  static Board square(double step) { return {{step, 0}, {0, step}}; }
};

/// The shortest vector of the lattice that points along (1, 0) or along (0, 1), if one below a few
/// metres does. [cm]
std::optional<double> latticePeriod(const Vec2& w1, const Vec2& w2, bool along_warp);

}  // namespace seamwise
