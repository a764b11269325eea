#include "alignment/seam_bound.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace seamwise {
namespace {

constexpr double kCoarse = 0.25;  ///< radius of samples, as a share of how far points move

}  // namespace

double SeamBound::Pair::steepness() const {
  double sum = 0;
  for (const double g : slope) sum += std::abs(g);
  return sum;
}

SeamBound::SeamBound(const MatchProblem& problem, const MatchSeam& seam)
    : problem_(problem), seam_(&seam) {
  const auto& [r1, r2] = problem.group.reducedBasis();
  const Mat2 basis = (Mat2() << r1, r2).finished();
  to_reduced_ = basis.inverse();
  g11_ = r1.squaredNorm(), g12_ = r1.dot(r2), g22_ = r2.squaredNorm();
  for (const Element& e : problem.group.elements()) {
    if (!problem.allows(seam, e)) continue;
    const Mat2 m = (to_reduced_ * e.A * basis).array().round();
    const Vec2 a = to_reduced_ * e.a;
    images_.push_back({&e, m(0, 0), m(0, 1), m(1, 0), m(1, 1), a.x(), a.y()});
  }
  // edges in groups of 1, 2, 4 ..., the last of them the whole seam
  const Vec2 &ca = problem.leaders[seam.a].centre, &cb = problem.leaders[seam.b].centre;
  const std::size_t edges = seam.w.size();
  for (std::size_t size = 1; size == 1 || size < 2 * edges; size *= 2) {
    Level& level = levels_.emplace_back();
    for (std::size_t first = 0; first < edges; first += size) {
      const std::size_t last = std::min(edges, first + size), middle = (first + last) / 2;
      Sample sample{seam.pa[middle] - ca, seam.pb[middle] - cb, 0, 0};
      for (std::size_t i = first; i < last; ++i) {
        sample.w += seam.w[i];
        sample.radius += seam.w[i] * ((seam.pa[i] - seam.pa[middle]).norm() +
                                      (seam.pb[i] - seam.pb[middle]).norm());
      }
      if (sample.w <= 0) continue;
      level.radius += sample.radius / seam.weight;
      sample.radius /= sample.w;
      level.samples.push_back(sample);
    }
  }
}

SeamBound::Nearest SeamBound::nearest(const Vec2& x, const Vec2& y) const {
  const Vec2 p = to_reduced_ * x, q = to_reduced_ * y;
  double first = std::numeric_limits<double>::max(), second = first;
  const Image* best = nullptr;
  for (const Image& e : images_) {
    double u = p.x() - (e.m00 * q.x() + e.m01 * q.y() + e.a0);
    double v = p.y() - (e.m10 * q.x() + e.m11 * q.y() + e.a1);
    u -= internal::roundNear(u), v -= internal::roundNear(v);
    // see WallpaperGroup::reduce
    const double g1 = u * g11_ + v * g12_, g2 = u * g12_ + v * g22_;
    const double nearer = std::min(0.0, std::min(g11_ - 2 * std::abs(g1), g22_ - 2 * std::abs(g2)));
    const double d = u * g1 + v * g2 + nearer;
    second = std::min(second, std::max(first, d));
    if (d < first) first = d, best = &e;
  }
  return {best->element, std::max(0.0, first), std::max(0.0, second)};
}

SeamBound::Pair SeamBound::between(const Box& a, double reach_a, const Box& b, double reach_b,
                                   double& spent) const {
  Pair pair;
  if (a.open || b.open) return pair;
  const WallpaperGroup& group = problem_.group;
  const auto& [r1, r2] = group.reducedBasis();
  const Vec2 repeats[3] = {r1, r2, r1 - r2};
  const double swing_a = a.swing(), swing_b = b.swing(), shift = a.shift() + b.shift();
  const double typical = reach_a * swing_a + reach_b * swing_b + shift;
  const Level* level = &levels_[0];
  for (const Level& coarser : levels_)
    if (coarser.radius <= kCoarse * typical) level = &coarser;
  const bool own = seam_->a == seam_->b;
  const Mat2 turn_a = rotation(-a.at.angle), turn_b = rotation(-b.at.angle);
  const Vec2 at_a = a.at.toPrint(problem_.leaders[seam_->a].centre),
             at_b = b.at.toPrint(problem_.leaders[seam_->b].centre);
  for (const Sample& s : level->samples) {
    const Vec2 za = turn_a * s.a, zb = turn_b * s.b, x = at_a + za, y = at_b + zb;
    const double rho = s.a.norm() * swing_a + s.b.norm() * swing_b + shift;
    const Nearest near = nearest(x, y);
    const Element& element = *near.element;
    const Vec2 r = group.reduce(x - element(y));
    const double d = r.norm();
    double second = near.second;  // of other elements, and of the same with other repeats
    for (const Vec2& repeat : repeats)
      second = std::min(second, near.first - 2 * std::abs(r.dot(repeat)) + repeat.squaredNorm());
    double flat = d - rho;
    if (own) {
      // both sides move together: of a rotation only their difference counts
      flat = std::numeric_limits<double>::max();
      for (const Image& image : images_) {
        const Element& e = *image.element;
        const double alone = e.mirrored ? rho
                                        : (za - e.A * zb).norm() * swing_a +
                                              2 * std::abs(std::sin(e.angle / 2)) * a.shift();
        flat = std::min(flat, group.reduce(x - e(y)).norm() - std::min(rho, alone));
      }
    }
    pair.cost += s.w * d;
    pair.flat += s.w * std::max(0.0, flat - s.radius);
    // others come as near as second - rho, this one as far as d + rho
    const double share =
        s.w * std::clamp((std::sqrt(std::max(0.0, second)) - rho) / (d + rho), 0.0, 1.0);
    const double bend = (a.turn * a.turn * s.a.norm() + b.turn * b.turn * s.b.norm()) / 2;
    if (d < 1e-12) {
      pair.middle -= s.w * s.radius;
      continue;
    }
    pair.middle += share * (d - bend) - s.w * s.radius;
    const Vec2 u = r * (share / d), v = element.A.transpose() * u;
    pair.slope[0] -= a.turn * u.dot(perp(za)), pair.slope[3] += b.turn * v.dot(perp(zb));
    for (int k = 0; k < 2; ++k)
      pair.slope[1 + k] += u.dot(a.half[k]), pair.slope[4 + k] -= v.dot(b.half[k]);
  }
  spent += static_cast<double>(level->samples.size() * (4 + group.elements().size()));
  return pair;
}

}  // namespace seamwise
