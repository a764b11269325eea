#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "alignment/model/sampled_seams_lanes.h"
#include "tuning/search.h"

namespace seamwise {
template <class Real>
typename SampledSeams<Real>::Model SampledSeams<Real>::model(int seam, const Pose& a, const Pose& b,
                                                             double slack) const {
  const Samples& samples = seams_[seam];
  bool shaped = false;
  double within = 1, outside = 1;
  Element join{};
  if (slack > 0 || std::isfinite(samples.limit)) {
    const Choice choice = chosen(seam, a, b, slack);
    if ((shaped = choice.shaped)) {
      join = choice.join.element;
      within = SearchTuning::kLeak, outside = 1 + SearchTuning::kLeak;
      if (choice.exceeds)
        within += SearchTuning::kLeftByShaping * SearchTuning::kBeyondLimit,
            outside += (1 + SearchTuning::kLeftByShaping) * SearchTuning::kBeyondLimit;
    } else if (choice.exceeds) {
      within = outside = 1 + SearchTuning::kBeyondLimit;
    }
  }
  const Real allowance = static_cast<Real>(shaped ? slack : 0);
  const Real leak = static_cast<Real>(within), beyond = static_cast<Real>(outside);
  const Vector none{};
  Vector sums[kSums] = {};
  for (int from = samples.from; from < samples.from + samples.count; from += kLanes) {
    const Placed p = placed(from, a.lattice, b.lattice);
    Vector s{}, t{}, c{}, n{}, det{};
    if (shaped) {
      s = p.x0 - (join.m00 * p.y0 + join.m01 * p.y1 + join.a0);
      t = p.x1 - (join.m10 * p.y0 + join.m11 * p.y1 + join.a1);
      c = none + join.cos, n = none + join.sin, det = none + join.det;
    } else {
      Vector best = none + std::numeric_limits<Real>::max();
      for (const Element& e : samples.elements->each) {
        const Offset o = offset(p, e);
        const Vector squared = o.squared();
        const auto less = squared < best;
        best = less ? squared : best;
        s = less ? o.s : s, t = less ? o.t : t;
        c = less ? none + e.cos : c, n = less ? none + e.sin : n, det = less ? none + e.det : det;
      }
      Offset nearest = reduced(s, t);
      nearest.reduce();
      s = nearest.s, t = nearest.t;
    }
    const Vector rx = s * u0x_ + t * u1x_, ry = s * u0y_ + t * u1y_;
    const Vector d = squareRoots(rx * rx + ry * ry);
    const Vector pull = d > allowance ? none + beyond : none + leak;
    const Vector w = loaded(&w_[from]) * pull /
                     greatest(d, none + static_cast<Real>(SearchTuning::kLeastDistance));
    // r = x - (A y + a + T) with A = (c, -det n; n, det c); the columns of its Jacobian are
    // j = -perp(x), I, k = A perp(y), -A
    const Vector ax = loaded(&ax_[from]), ay = loaded(&ay_[from]);
    const Vector bx = loaded(&bx_[from]), by = loaded(&by_[from]);
    const Vector jx = a.cos * ay - a.sin * ax, jy = -(a.cos * ax + a.sin * ay);
    const Vector px = b.sin * bx - b.cos * by, py = b.cos * bx + b.sin * by;
    const Vector dc = det * c, dn = det * n;
    const Vector kx = c * px - dn * py, ky = n * px + dc * py;
    const Vector wrx = w * rx, wry = w * ry, wjx = w * jx, wjy = w * jy, wkx = w * kx, wky = w * ky;
    const Vector terms[kSums] = {jx * wrx + jy * wry,
                                 wrx,
                                 wry,
                                 kx * wrx + ky * wry,
                                 -c * wrx - n * wry,
                                 dn * wrx - dc * wry,
                                 jx * wjx + jy * wjy,
                                 wjx,
                                 wjy,
                                 w,
                                 jx * wkx + jy * wky,
                                 wkx,
                                 wky,
                                 kx * wkx + ky * wky,
                                 -c * wjx - n * wjy,
                                 dn * wjx - dc * wjy,
                                 -w * c,
                                 -w * n,
                                 w * dn,
                                 -w * dc,
                                 -c * wkx - n * wky,
                                 dn * wkx - dc * wky};
    for (int k = 0; k < kSums; ++k) sums[k] += terms[k];
  }
  double sum[kSums];
  for (int k = 0; k < kSums; ++k) sum[k] = sumOf(sums[k]);
  Model m;
  for (int k = 0; k < 6; ++k) m.gradient[k] = sum[k];
  auto& h = m.hessian;
  h(0, 0) = sum[6], h(1, 0) = sum[7], h(2, 0) = sum[8];
  h(1, 1) = h(2, 2) = h(4, 4) = h(5, 5) = sum[9];
  h(2, 1) = h(5, 4) = 0;
  h(3, 0) = sum[10], h(3, 1) = sum[11], h(3, 2) = sum[12], h(3, 3) = sum[13];
  h(4, 0) = sum[14], h(5, 0) = sum[15];
  h(4, 1) = sum[16], h(4, 2) = sum[17], h(5, 1) = sum[18], h(5, 2) = sum[19];
  h(4, 3) = sum[20], h(5, 3) = sum[21];
  return m;
}

template SampledSeams<float>::Model SampledSeams<float>::model(int, const Pose&, const Pose&,
                                                               double) const;
template SampledSeams<double>::Model SampledSeams<double>::model(int, const Pose&, const Pose&,
                                                                 double) const;

}  // namespace seamwise
