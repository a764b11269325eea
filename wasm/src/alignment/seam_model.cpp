#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "alignment/sampled_seams_lanes.h"

namespace seamwise {
namespace {

constexpr double kFloor = 0.02;  ///< cm: distances below it are weighted as if they were it

}  // namespace

/// The pose in coordinates of the lattice.
template <class Real>
typename SampledSeams<Real>::Pose SampledSeams<Real>::onLattice(const Pose& pose) const {
  if (shape_ == Chamber::Shape::kCell) return pose;
  const Mat2 m = to_lattice_ * (Mat2() << pose.m00, pose.m01, pose.m10, pose.m11).finished();
  const Vec2 t = to_lattice_ * (Vec2(pose.t0, pose.t1) - pose_offset_);
  const auto real = [](double v) { return static_cast<Real>(v); };
  return {real(m(0, 0)), real(m(0, 1)), real(m(1, 0)), real(m(1, 1)),
          real(t.x()),   real(t.y()),   pose.cos,      pose.sin};
}

template <class Real>
typename SampledSeams<Real>::Model SampledSeams<Real>::model(int seam, const Pose& at_a,
                                                             const Pose& at_b, double slack) const {
  const Pose a = onLattice(at_a), b = onLattice(at_b);
  const Samples& samples = seams_[seam];
  const Real allowance = static_cast<Real>(slack);
  double within = slack > 0 ? SeamCosts::kLeak : 1, outside = slack > 0 ? 1 + SeamCosts::kLeak : 1;
  if (std::isfinite(samples.limit)) {
    const Excess broken = excess(seam, sums(seam, at_a, at_b, slack), slack);
    if (broken == Excess::kOfAll) within += SeamCosts::kHard, outside += SeamCosts::kHard;
    if (broken == Excess::kOfBeyond)
      within += kLeftByShaping * SeamCosts::kHard,
          outside += (1 + kLeftByShaping) * SeamCosts::kHard;
  }
  const Real leak = static_cast<Real>(within), beyond = static_cast<Real>(outside);
  const Real ac = static_cast<Real>(a.cos), as = static_cast<Real>(a.sin);
  const Real bc = static_cast<Real>(b.cos), bs = static_cast<Real>(b.sin);
  const Vector none{};
  Vector sums[kSums] = {};
  for (int from = samples.from; from < samples.from + samples.count; from += kLanes) {
    const Placed p = placed(from, a, b);
    Vector best = none + std::numeric_limits<Real>::max();
    Vector s{}, t{}, c{}, n{}, det{};
    for (const Element& e : *samples.elements) {
      const Offset o = offset(p, e);
      const Vector squared = o.squared();
      const auto less = squared < best;
      best = less ? squared : best;
      s = less ? o.s : s, t = less ? o.t : t;
      c = less ? none + e.cos : c, n = less ? none + e.sin : n, det = less ? none + e.det : det;
    }
    Offset nearest = reduced(s, t);
    nearest.reduce();
    const Vector rx = nearest.s * u0x_ + nearest.t * u1x_, ry = nearest.s * u0y_ + nearest.t * u1y_;
    const Vector d = squareRoots(rx * rx + ry * ry);
    const Vector pull = d > allowance ? none + beyond : none + leak;
    const Vector w = loaded(&w_[from]) * pull / greatest(d, none + static_cast<Real>(kFloor));
    // r = x - (A y + a + T) with A = (c, -det n; n, det c); the columns of its Jacobian are
    // j = -perp(x), I, k = A perp(y), -A
    const Vector ax = loaded(&ax_[from]), ay = loaded(&ay_[from]);
    const Vector bx = loaded(&bx_[from]), by = loaded(&by_[from]);
    const Vector jx = ac * ay - as * ax, jy = -(ac * ax + as * ay);
    const Vector px = bs * bx - bc * by, py = bc * bx + bs * by;
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

template SampledSeams<float>::Pose SampledSeams<float>::onLattice(const Pose&) const;
template SampledSeams<double>::Pose SampledSeams<double>::onLattice(const Pose&) const;
template SampledSeams<float>::Model SampledSeams<float>::model(int, const Pose&, const Pose&,
                                                               double) const;
template SampledSeams<double>::Model SampledSeams<double>::model(int, const Pose&, const Pose&,
                                                                 double) const;

}  // namespace seamwise
