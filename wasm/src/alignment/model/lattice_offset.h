#pragma once
#include "base/lanes.h"
#include "wallpaper/group.h"

namespace seamwise {

/// A few offsets modulo the lattice, in coordinates of the reduced basis: within half a cell of a
/// lattice point that is nearest, or next to the nearest, to the origin (see
/// WallpaperGroup::reduce).
template <class Real>
struct LatticeOffset {
  using Vector = typename Lanes<Real>::Vector;
  Vector s, t;    ///< in (-1/2, 1/2)
  Vector g1, g2;  ///< products with the basis
  Vector n1, n2;  ///< change of the square by one lattice point towards the offset

  /// @param g11, g12, g22   metric of the reduced basis, 0 <= 2 g12 <= g11 <= g22
  [[gnu::always_inline]] LatticeOffset(const Vector& s0, const Vector& t0, Real g11, Real g12,
                                       Real g22) {
    s = s0 - internal::roundNear(s0), t = t0 - internal::roundNear(t0);
    g1 = s * g11 + t * g12, g2 = s * g12 + t * g22;
    n1 = g11 - 2 * abs(g1), n2 = g22 - 2 * abs(g2);
  }

  [[gnu::always_inline]] Vector squared() const {
    return s * g1 + t * g2 + least(least(n1, n2), Vector{});
  }
  /// Moves s and t to the nearest lattice point.
  void reduce() {
    const Vector none{}, one = none + 1;
    const Vector step1 = g1 < 0 ? one : -one, step2 = g2 < 0 ? one : -one;
    const Vector shift0 = n1 < n2 ? step1 : none, shift1 = n1 < n2 ? none : step2;
    const Vector nearer = least(n1, n2);
    s += nearer < 0 ? shift0 : none, t += nearer < 0 ? shift1 : none;
  }
};

}  // namespace seamwise
