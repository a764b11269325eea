#pragma once
// Common parts of cost and model of SampledSeams: a few samples at once on the print.
#include "alignment/model/sampled_seams.h"

namespace seamwise {

/// Both sides of a few samples on the print, in reduced coordinates.
template <class Real>
struct SampledSeams<Real>::Placed {
  Vector x0, x1, y0, y1;
};

// The innermost loops call these. Clang does not inline them without the attribute.

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
  return {s0, t0, g11_, g12_, g22_};
}

/// x - (A y + a), modulo the lattice.
template <class Real>
[[gnu::always_inline]] inline typename SampledSeams<Real>::Offset SampledSeams<Real>::offset(
    const Placed& p, const Element& e) const {
  return reduced(p.x0 - (e.m00 * p.y0 + e.m01 * p.y1 + e.a0),
                 p.x1 - (e.m10 * p.y0 + e.m11 * p.y1 + e.a1));
}

}  // namespace seamwise
