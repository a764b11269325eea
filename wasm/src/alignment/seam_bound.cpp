#include "alignment/seam_bound.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace seamwise {
namespace {

constexpr double kCoarse = 0.25;  ///< radius of samples, as a share of how far points move
constexpr double kSingle = 2e-7;  ///< relative error of places in single precision

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
  const auto real = [](double v) { return static_cast<Real>(v); };
  u0x_ = real(r1.x()), u0y_ = real(r1.y()), u1x_ = real(r2.x()), u1y_ = real(r2.y());
  g11_ = real(r1.squaredNorm()), g12_ = real(r1.dot(r2)), g22_ = real(r2.squaredNorm());
  for (const Element& e : problem.group.elements()) {
    if (!problem.allows(seam, e)) continue;
    const Mat2 m = (to_reduced_ * e.A * basis).array().round();
    const Vec2 a = to_reduced_ * e.a;
    images_.push_back({&e, real(m(0, 0)), real(m(0, 1)), real(m(1, 0)), real(m(1, 1)), real(a.x()),
                       real(a.y()), real(e.A(0, 0)), real(e.A(1, 0)), real(e.mirrored ? -1 : 1)});
  }
  // edges in groups of 1, 2, 4 ..., the last of them the whole seam
  const Vec2 &ca = problem.leaders[seam.a].centre, &cb = problem.leaders[seam.b].centre;
  const std::size_t edges = seam.w.size();
  double far = r2.norm();
  for (std::size_t size = 1; size == 1 || size < 2 * edges; size *= 2) {
    Level& level = levels_.emplace_back();
    for (std::size_t first = 0; first < edges; first += size) {
      const std::size_t last = std::min(edges, first + size), middle = (first + last) / 2;
      double w = 0, radius = 0;
      for (std::size_t i = first; i < last; ++i) {
        w += seam.w[i];
        radius += seam.w[i] *
                  ((seam.pa[i] - seam.pa[middle]).norm() + (seam.pb[i] - seam.pb[middle]).norm());
      }
      if (w <= 0) continue;
      const Vec2 a = seam.pa[middle] - ca, b = seam.pb[middle] - cb;
      level.ax.push_back(real(a.x())), level.ay.push_back(real(a.y()));
      level.bx.push_back(real(b.x())), level.by.push_back(real(b.y()));
      level.far_a.push_back(real(a.norm())), level.far_b.push_back(real(b.norm()));
      level.w.push_back(real(w)), level.radius.push_back(real(radius / w));
      level.mean_radius += radius / seam.weight;
      far = std::max({far, a.norm(), b.norm()});
    }
    const std::size_t padded = (level.w.size() + kLanes - 1) / kLanes * kLanes;
    for (auto* array : {&level.ax, &level.ay, &level.bx, &level.by, &level.far_a, &level.far_b,
                        &level.w, &level.radius})
      array->resize(padded, 0);
  }
  rounding_ = kSingle * far * seam.weight;
}

SeamBound::Pose SeamBound::pose(int leader, const Alignment& at) const {
  const double c = std::cos(at.angle), s = std::sin(at.angle);
  const Mat2 m = to_reduced_ * (Mat2() << c, s, -s, c).finished();
  Vec2 t = m * (problem_.leaders[leader].centre - at.translation);
  t -= t.array().round().matrix();
  const auto real = [](double v) { return static_cast<Real>(v); };
  return {real(m(0, 0)), real(m(0, 1)), real(m(1, 0)), real(m(1, 1)),
          real(t.x()),   real(t.y()),   real(c),       real(s)};
}

/// The flat bound of a seam whose sides move together: of a rotation only their difference counts.
double SeamBound::ownFlat(const Level& level, const Box& box) const {
  const WallpaperGroup& group = problem_.group;
  const Mat2 turn = rotation(-box.at.angle);
  const Vec2 at = box.at.toPrint(problem_.leaders[seam_->a].centre);
  double sum = 0;
  for (std::size_t i = 0; i < level.w.size(); ++i) {
    const Vec2 za = turn * Vec2(level.ax[i], level.ay[i]),
               zb = turn * Vec2(level.bx[i], level.by[i]);
    const double rho = (level.far_a[i] + level.far_b[i]) * box.swing() + 2 * box.shift();
    double flat = std::numeric_limits<double>::max();
    for (const Image& image : images_) {
      const Element& e = *image.element;
      const double alone = e.mirrored ? rho
                                      : (za - e.A * zb).norm() * box.swing() +
                                            2 * std::abs(std::sin(e.angle / 2)) * box.shift();
      flat = std::min(flat, group.reduce(at + za - e(at + zb)).norm() - std::min(rho, alone));
    }
    sum += level.w[i] * std::max(0.0, flat - level.radius[i]);
  }
  return sum;
}

SeamBound::Pair SeamBound::between(const Box& a, double reach_a, const Box& b, double reach_b,
                                   double& spent) const {
  const double typical = reach_a * a.swing() + reach_b * b.swing() + a.shift() + b.shift();
  const Level* level = &levels_[0];
  for (const Level& coarser : levels_)
    if (coarser.mean_radius <= kCoarse * typical) level = &coarser;
  const Real swing_a = static_cast<Real>(a.swing()), swing_b = static_cast<Real>(b.swing());
  const Real shift = static_cast<Real>(a.shift() + b.shift());
  const Real bend_a = static_cast<Real>(a.turn * a.turn / 2),
             bend_b = static_cast<Real>(b.turn * b.turn / 2);
  const bool turns = a.turn > 0 || b.turn > 0;
  const Pose pa = pose(seam_->a, a.at), pb = pose(seam_->b, b.at);
  const Vector none{};
  const Real g33 = g11_ - 2 * g12_ + g22_;
  Vector cost{}, flat{}, middle{}, ux{}, uy{}, vx{}, vy{}, turn_a{}, turn_b{};
  for (std::size_t from = 0; from < level->w.size(); from += kLanes) {
    const Vector ax = loaded(&level->ax[from]), ay = loaded(&level->ay[from]);
    const Vector bx = loaded(&level->bx[from]), by = loaded(&level->by[from]);
    const Vector x0 = pa.m00 * ax + pa.m01 * ay + pa.t0, x1 = pa.m10 * ax + pa.m11 * ay + pa.t1;
    const Vector y0 = pb.m00 * bx + pb.m01 * by + pb.t0, y1 = pb.m10 * bx + pb.m11 * by + pb.t1;
    Vector first = none + std::numeric_limits<Real>::max(), second = first;
    Vector s{}, t{}, c{}, n{}, det{};
    for (const Image& e : images_) {
      const Vector s0 = x0 - (e.m00 * y0 + e.m01 * y1 + e.a0),
                   t0 = x1 - (e.m10 * y0 + e.m11 * y1 + e.a1);
      const Vector os = s0 - internal::roundNear(s0), ot = t0 - internal::roundNear(t0);
      const Vector g1 = os * g11_ + ot * g12_, g2 = os * g12_ + ot * g22_;
      const Vector nearer = least(least(g11_ - 2 * abs(g1), g22_ - 2 * abs(g2)), none);
      const Vector d = os * g1 + ot * g2 + nearer;
      second = least(second, greatest(first, d));
      const auto less = d < first;
      first = less ? d : first;
      s = less ? os : s, t = less ? ot : t;
      c = less ? none + e.cos : c, n = less ? none + e.sin : n, det = less ? none + e.det : det;
    }
    // on to the nearest lattice point
    Vector g1 = s * g11_ + t * g12_, g2 = s * g12_ + t * g22_;
    const Vector n1 = g11_ - 2 * abs(g1), n2 = g22_ - 2 * abs(g2), nearer = least(n1, n2);
    const Vector one = none + 1;
    const Vector step1 = g1 < 0 ? one : -one, step2 = g2 < 0 ? one : -one;
    const Vector shift0 = n1 < n2 ? step1 : none, shift1 = n1 < n2 ? none : step2;
    s += nearer < 0 ? shift0 : none, t += nearer < 0 ? shift1 : none;
    g1 = s * g11_ + t * g12_, g2 = s * g12_ + t * g22_;
    // the same element comes as near with other repeats
    second = least(second, first + g11_ - 2 * abs(g1));
    second = least(second, first + g22_ - 2 * abs(g2));
    second = least(second, first + g33 - 2 * abs(g1 - g2));
    const Vector d = squareRoots(greatest(first, none));
    const Vector w = loaded(&level->w[from]), radius = loaded(&level->radius[from]);
    const Vector far_a = loaded(&level->far_a[from]), far_b = loaded(&level->far_b[from]);
    const Vector rho = far_a * swing_a + far_b * swing_b + shift;
    cost += w * d;
    flat += w * greatest(d - rho - radius, none);
    // others come as near as second - rho, this one as far as d + rho
    Vector share = least(
        greatest((squareRoots(greatest(second, none)) - rho) / greatest(d + rho, none + Real(1e-9)),
                 none),
        one);
    share = d > Real(1e-9) ? w * share : none;
    middle += share * (d - bend_a * far_a - bend_b * far_b) - w * radius;
    const Vector scale = share / greatest(d, none + Real(1e-9));
    const Vector px = (s * u0x_ + t * u1x_) * scale, py = (s * u0y_ + t * u1y_) * scale;
    const Vector qx = c * px + n * py, qy = det * (c * py - n * px);
    ux += px, uy += py, vx += qx, vy += qy;
    if (turns) {
      turn_a += py * (pa.cos * ax + pa.sin * ay) - px * (pa.cos * ay - pa.sin * ax);
      turn_b += qy * (pb.cos * bx + pb.sin * by) - qx * (pb.cos * by - pb.sin * bx);
    }
  }
  Pair pair;
  pair.cost = sumOf(cost), pair.middle = sumOf(middle) - rounding_;
  const double either = seam_->a == seam_->b ? ownFlat(*level, a) : sumOf(flat);
  pair.flat = std::max(0.0, either - rounding_);
  pair.slope[0] = -a.turn * sumOf(turn_a), pair.slope[3] = b.turn * sumOf(turn_b);
  const Vec2 u(sumOf(ux), sumOf(uy)), v(sumOf(vx), sumOf(vy));
  for (int k = 0; k < 2; ++k)
    pair.slope[1 + k] = u.dot(a.half[k]), pair.slope[4 + k] = -v.dot(b.half[k]);
  spent += static_cast<double>(level->w.size() * (4 + images_.size()));
  return pair;
}

}  // namespace seamwise
