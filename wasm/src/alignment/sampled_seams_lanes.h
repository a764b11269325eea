#pragma once
// What cost and model of SampledSeams share: a few samples at once on the print.
#include "alignment/sampled_seams.h"

namespace seamwise {

/// Shares that a seam's cost is made of.
struct SeamCosts {
  /// Of a distance that counts inside the slack: ties go to the better.
  static constexpr double kLeak = 0.1;
  /// What a seam misses by beyond its limit counts so many times more.
  static constexpr double kHard = 6;
};

/// Both sides of a few samples on the print, in reduced coordinates.
template <class Real>
struct SampledSeams<Real>::Placed {
  Vector x0, x1, y0, y1;
};

/// x - (A y + a), modulo the lattice: within half a cell of a lattice point that is nearest, or
/// next to the nearest, to the origin (see WallpaperGroup::reduce).
template <class Real>
struct SampledSeams<Real>::Offset {
  Vector s, t, g1, g2, n1, n2;

  [[gnu::always_inline]] Vector squared() const {
    return s * g1 + t * g2 + least(least(n1, n2), Vector{});
  }
  /// Moves on to the nearest lattice point.
  void reduce() {
    const Vector none{}, one = none + 1;
    const Vector step1 = g1 < 0 ? one : -one, step2 = g2 < 0 ? one : -one;
    const Vector shift0 = n1 < n2 ? step1 : none, shift1 = n1 < n2 ? none : step2;
    const Vector nearer = least(n1, n2);
    s += nearer < 0 ? shift0 : none, t += nearer < 0 ? shift1 : none;
  }
};

// The innermost loops call these: Clang would not inline them by itself.

template <class Real>
[[gnu::always_inline]] inline typename SampledSeams<Real>::Placed SampledSeams<Real>::placed(
    int from, const typename Pose::Map& a, const typename Pose::Map& b) const {
  const Vector ax = loaded(&ax_[from]), ay = loaded(&ay_[from]);
  const Vector bx = loaded(&bx_[from]), by = loaded(&by_[from]);
  return {a.m00 * ax + a.m01 * ay + a.t0, a.m10 * ax + a.m11 * ay + a.t1,
          b.m00 * bx + b.m01 * by + b.t0, b.m10 * bx + b.m11 * by + b.t1};
}

template <class Real>
[[gnu::always_inline]] inline typename SampledSeams<Real>::Offset SampledSeams<Real>::reduced(
    const Vector& s0, const Vector& t0) const {
  Offset o;
  o.s = s0 - internal::roundNear(s0), o.t = t0 - internal::roundNear(t0);
  o.g1 = o.s * g11_ + o.t * g12_, o.g2 = o.s * g12_ + o.t * g22_;
  o.n1 = g11_ - 2 * abs(o.g1), o.n2 = g22_ - 2 * abs(o.g2);
  return o;
}

template <class Real>
[[gnu::always_inline]] inline typename SampledSeams<Real>::Offset SampledSeams<Real>::offset(
    const Placed& p, const Element& e) const {
  return reduced(p.x0 - (e.m00 * p.y0 + e.m01 * p.y1 + e.a0),
                 p.x1 - (e.m10 * p.y0 + e.m11 * p.y1 + e.a1));
}

}  // namespace seamwise
