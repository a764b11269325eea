#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment/model/sampled_seams_lanes.h"
#include "tuning/search.h"

namespace seamwise {
template <class Real>
void SampledSeams<Real>::Elements::pack() {
  for (std::size_t from = 0; from < each.size(); from += kLanes) {
    Few some;
    for (std::size_t k = 0; k < kLanes; ++k) {
      const Element& e = each[std::min(from + k, each.size() - 1)];
      some.m00[k] = e.m00, some.m01[k] = e.m01, some.m10[k] = e.m10, some.m11[k] = e.m11;
      some.a0[k] = e.a0, some.a1[k] = e.a1;
      some.cos[k] = e.cos, some.sin[k] = e.sin, some.det[k] = e.det;
    }
    few.push_back(some);
  }
}

/// Computes the moments for a join by least squares.
template <class Real>
void SampledSeams<Real>::measure(Samples& samples) const {
  const auto first = static_cast<std::size_t>(samples.from);
  const auto end = first + static_cast<std::size_t>(samples.count);
  double weight = 0;
  Vec2 mean_a = Vec2::Zero(), mean_b = Vec2::Zero();
  for (std::size_t k = first; k < end; ++k) {
    const double w = w_[k];
    weight += w, mean_a += w * Vec2(ax_[k], ay_[k]), mean_b += w * Vec2(bx_[k], by_[k]);
  }
  if (weight <= 0) return;
  mean_a /= weight, mean_b /= weight;
  Mat2 products = Mat2::Zero();
  double spread = 0;
  for (std::size_t k = first; k < end; ++k) {
    const double w = w_[k];
    const Vec2 a = Vec2(ax_[k], ay_[k]) - mean_a, b = Vec2(bx_[k], by_[k]) - mean_b;
    products += w * a * b.transpose();
    spread += w * (a.squaredNorm() + b.squaredNorm());
  }
  const auto real = [](double v) { return static_cast<Real>(v); };
  samples.weight = real(weight), samples.spread = real(spread);
  samples.mean_ax = real(mean_a.x()), samples.mean_ay = real(mean_a.y());
  samples.mean_bx = real(mean_b.x()), samples.mean_by = real(mean_b.y());
  samples.axbx = real(products(0, 0)), samples.axby = real(products(0, 1));
  samples.aybx = real(products(1, 0)), samples.ayby = real(products(1, 1));
}

/// The join with the least sum of w r2 = weight |mean x - A mean y - a|2 + spread
/// - 2 trace(A^T sum of w (x - mean x) (y - mean y)^T).
template <class Real>
typename SampledSeams<Real>::Through SampledSeams<Real>::through(const Samples& of, const Pose& a,
                                                                 const Pose& b,
                                                                 double slack) const {
  const auto &la = a.lattice, &lb = b.lattice;
  const Real x0 = la.m00 * of.mean_ax + la.m01 * of.mean_ay + la.t0;
  const Real x1 = la.m10 * of.mean_ax + la.m11 * of.mean_ay + la.t1;
  const Real y0 = lb.m00 * of.mean_bx + lb.m01 * of.mean_by + lb.t0;
  const Real y1 = lb.m10 * of.mean_bx + lb.m11 * of.mean_by + lb.t1;
  // The products in print space; the angle of a piece is turned back.
  const Real c00 = of.axbx * b.cos + of.axby * b.sin, c01 = of.axby * b.cos - of.axbx * b.sin;
  const Real c10 = of.aybx * b.cos + of.ayby * b.sin, c11 = of.ayby * b.cos - of.aybx * b.sin;
  const Real xx = a.cos * c00 + a.sin * c10, xy = a.cos * c01 + a.sin * c11;
  const Real yx = a.cos * c10 - a.sin * c00, yy = a.cos * c11 - a.sin * c01;
  Through best{};
  Real best_value = std::numeric_limits<Real>::max();
  for (std::size_t from = 0; from < of.elements->each.size(); from += kLanes) {
    const auto& e = of.elements->few[from / kLanes];
    const Vector s0 = x0 - (e.m00 * y0 + e.m01 * y1), t0 = x1 - (e.m10 * y0 + e.m11 * y1);
    Offset mean = reduced(s0 - e.a0, t0 - e.a1);
    const Vector value =
        of.weight * mean.squared() - 2 * (e.cos * (xx + e.det * yy) + e.sin * (yx - e.det * xy));
    mean.reduce();
    const Vector a0 = s0 - mean.s, a1 = t0 - mean.t;
    for (std::size_t k = 0; k < kLanes; ++k) {
      if (value[k] >= best_value) continue;
      best_value = value[k];
      best.element = of.elements->each[std::min(from + k, of.elements->each.size() - 1)];
      best.element.a0 = a0[k], best.element.a1 = a1[k];
    }
  }
  const Real reach = static_cast<Real>(SearchTuning::kShapedUpTo * slack);
  best.within_reach = best_value + of.spread <= reach * reach * of.weight;
  return best;
}

template <class Real>
typename SampledSeams<Real>::Sums SampledSeams<Real>::sumsThrough(const Element& join,
                                                                  const Samples& of, const Pose& a,
                                                                  const Pose& b,
                                                                  double slack) const {
  const Real allowance = static_cast<Real>(slack);
  const Vector none{};
  Vector all{}, beyond{};
  for (int from = of.from; from < of.from + of.count; from += kLanes) {
    const Placed p = placed(from, a.lattice, b.lattice);
    const Vector s = p.x0 - (join.m00 * p.y0 + join.m01 * p.y1 + join.a0);
    const Vector t = p.x1 - (join.m10 * p.y0 + join.m11 * p.y1 + join.a1);
    const Vector squared = s * (s * g11_ + t * (2 * g12_)) + t * (t * g22_);
    const Vector r = squareRoots(greatest(squared, none)), w = loaded(&w_[from]);
    all += w * r;
    beyond += w * greatest(r - allowance, none);
  }
  return {sumOf(all), sumOf(beyond)};
}

template <class Real>
typename SampledSeams<Real>::Choice SampledSeams<Real>::chosen(int seam, const Pose& a,
                                                               const Pose& b, double slack) const {
  const Samples& of = seams_[seam];
  const auto taken = [&](bool shaped, double cost, double mismatch) {
    const double excess = std::max(0.0, mismatch - of.limit);
    return Choice{shaped, excess > 0, cost + SearchTuning::kBeyondLimit * excess, {}};
  };
  const auto unshaped = [&] {
    const double all = sum(seam, a, b);
    return taken(false, all, all);
  };
  if (slack <= 0) return unshaped();
  const Through join = through(of, a, b, slack);
  if (!join.within_reach) return unshaped();
  const Sums left = sumsThrough(join.element, of, a, b, slack);
  Choice shaped = taken(true, left.beyond + SearchTuning::kLeak * left.all,
                        left.beyond + SearchTuning::kLeftByShaping * left.all);
  shaped.join = join;
  if (left.beyond == 0) return shaped;
  const Choice other = unshaped();
  return shaped.cost <= other.cost ? shaped : other;
}

template void SampledSeams<float>::Elements::pack();
template void SampledSeams<float>::measure(Samples&) const;
template SampledSeams<float>::Through SampledSeams<float>::through(const Samples&, const Pose&,
                                                                   const Pose&, double) const;
template SampledSeams<float>::Sums SampledSeams<float>::sumsThrough(const Element&, const Samples&,
                                                                    const Pose&, const Pose&,
                                                                    double) const;
template SampledSeams<float>::Choice SampledSeams<float>::chosen(int, const Pose&, const Pose&,
                                                                 double) const;
template void SampledSeams<double>::Elements::pack();
template void SampledSeams<double>::measure(Samples&) const;
template SampledSeams<double>::Through SampledSeams<double>::through(const Samples&, const Pose&,
                                                                     const Pose&, double) const;
template SampledSeams<double>::Sums SampledSeams<double>::sumsThrough(const Element&,
                                                                      const Samples&, const Pose&,
                                                                      const Pose&, double) const;
template SampledSeams<double>::Choice SampledSeams<double>::chosen(int, const Pose&, const Pose&,
                                                                   double) const;

}  // namespace seamwise
