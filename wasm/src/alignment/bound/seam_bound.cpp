#include "alignment/bound/seam_bound.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "tuning/proof.h"

namespace seamwise {
namespace {

constexpr double kSingle = 2e-7;  ///< relative error of positions in single precision

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
  // Groups of 1, 2, 4 ... edges; the last one is the whole seam.
  const Vec2 &ca = problem.leaders[seam.a].centre, &cb = problem.leaders[seam.b].centre;
  const std::size_t edges = seam.w.size();
  double far = r2.norm();
  for (std::size_t size = 1; size == 1 || size < 2 * edges; size *= 2) {
    Level& level = levels_.emplace_back();
    for (std::size_t first = 0; first < edges; first += size) {
      const std::size_t last = std::min(edges, first + size);
      const Stretch group = seam.stretch(first, last);
      double w = 0, spread = 0, radius = 0, far_a = 0, far_b = 0;
      for (std::size_t i = first; i < last; ++i) {
        const double off = (seam.pa[i] - group.mean_a).norm() + (seam.pb[i] - group.mean_b).norm();
        w += seam.w[i], spread += seam.w[i] * off;
        radius = std::max(radius, off);
        far_a = std::max(far_a, (seam.pa[i] - ca).norm());
        far_b = std::max(far_b, (seam.pb[i] - cb).norm());
      }
      if (w <= 0) continue;
      const Vec2 a = group.mean_a - ca, b = group.mean_b - cb;
      level.ax.push_back(real(a.x())), level.ay.push_back(real(a.y()));
      level.bx.push_back(real(b.x())), level.by.push_back(real(b.y()));
      level.far_a.push_back(real(far_a)), level.far_b.push_back(real(far_b));
      level.w.push_back(real(w)), level.radius.push_back(real(radius));
      level.spread.push_back(real(spread / w));
      level.mean_spread += spread / seam.weight;
      far = std::max({far, far_a, far_b});
    }
    const std::size_t padded = (level.w.size() + kLanes - 1) / kLanes * kLanes;
    for (auto* array : {&level.ax, &level.ay, &level.bx, &level.by, &level.far_a, &level.far_b,
                        &level.w, &level.radius, &level.spread})
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

/// The flat bound of a seam whose sides move together, for which only their difference counts under
/// a rotation.
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
    sum += level.w[i] * std::max(0.0, flat - static_cast<double>(level.spread[i]));
  }
  return sum;
}

/// Linear functions of the turns and shifts of two boxes: values at the centres, and slopes.
struct SeamBound::Lines {
  Vector middle{}, ux{}, uy{}, vx{}, vy{}, turn_a{}, turn_b{};

  template <class Mask>
  [[gnu::always_inline]] void add(const Lines& other, const Mask& where) {
    const Vector none{};
    middle += where ? other.middle : none;
    ux += where ? other.ux : none, uy += where ? other.uy : none;
    vx += where ? other.vx : none, vy += where ? other.vy : none;
    turn_a += where ? other.turn_a : none, turn_b += where ? other.turn_b : none;
  }
};

/// Sums the lines over their lanes. Both sides of a seam of one piece move by the slopes of side a.
SeamBound::Pair SeamBound::sumOfLines(const Lines& lines, const Box& a, const Box& b) const {
  const Vec2 u(sumOf(lines.ux), sumOf(lines.uy)), v(sumOf(lines.vx), sumOf(lines.vy));
  Pair sum;
  sum.middle = sumOf(lines.middle) - rounding_;
  sum.slope = {-a.turn * sumOf(lines.turn_a), u.dot(a.half[0]),  u.dot(a.half[1]),
               b.turn * sumOf(lines.turn_b),  -v.dot(b.half[0]), -v.dot(b.half[1])};
  if (seam_->a == seam_->b)
    for (int k = 0; k < 3; ++k) sum.slope[k] += sum.slope[3 + k], sum.slope[3 + k] = 0;
  sum.least = sum.middle - sum.steepness();
  return sum;
}

SeamBound::Pair SeamBound::between(const Box& a, double reach_a, const Box& b, double reach_b,
                                   double& spent) const {
  const double typical = reach_a * a.swing() + reach_b * b.swing() + a.shift() + b.shift();
  const Level* level = &levels_[0];
  for (const Level& coarser : levels_)
    if (coarser.mean_spread <= ProofTuning::kGroupSpread * typical) level = &coarser;
  const auto real = [](double v) { return static_cast<Real>(v); };
  const Real swing_a = real(a.swing()), swing_b = real(b.swing());
  const Real shift = real(a.shift() + b.shift()), farther = real(1 + a.turn + b.turn);
  const Real most_a = real(a.turn), most_b = real(b.turn);
  const Real bend_a = most_a * most_a / 2, bend_b = most_b * most_b / 2;
  const Real ax0 = real(a.half[0].x()), ay0 = real(a.half[0].y());
  const Real ax1 = real(a.half[1].x()), ay1 = real(a.half[1].y());
  const Real bx0 = real(b.half[0].x()), by0 = real(b.half[0].y());
  const Real bx1 = real(b.half[1].x()), by1 = real(b.half[1].y());
  const bool turns = a.turn > 0 || b.turn > 0, rectangular = g12_ == 0;
  const Pose pa = pose(seam_->a, a.at), pb = pose(seam_->b, b.at);
  const Vector none{}, one = none + 1, tiny = none + Real(1e-9);
  const Real g33 = g11_ - 2 * g12_ + g22_;
  Vector flat{};
  Lines far, close;
  for (std::size_t from = 0; from < level->w.size(); from += kLanes) {
    const Vector ax = loaded(&level->ax[from]), ay = loaded(&level->ay[from]);
    const Vector bx = loaded(&level->bx[from]), by = loaded(&level->by[from]);
    const Vector x0 = pa.m00 * ax + pa.m01 * ay + pa.t0, x1 = pa.m10 * ax + pa.m11 * ay + pa.t1;
    const Vector y0 = pb.m00 * bx + pb.m01 * by + pb.t0, y1 = pb.m10 * bx + pb.m11 * by + pb.t1;
    Vector first = none + std::numeric_limits<Real>::max(), second = first;
    Vector s{}, t{}, c{}, n{}, det{};
    for (const Image& e : images_) {
      const LatticeOffset<Real> o(x0 - (e.m00 * y0 + e.m01 * y1 + e.a0),
                                  x1 - (e.m10 * y0 + e.m11 * y1 + e.a1), g11_, g12_, g22_);
      // A rectangular lattice has its nearest point in each coordinate separately.
      const Vector d = rectangular ? o.s * o.s * g11_ + o.t * o.t * g22_ : o.squared();
      second = least(second, greatest(first, d));
      const auto less = d < first;
      first = less ? d : first;
      s = less ? o.s : s, t = less ? o.t : t;
      c = less ? none + e.cos : c, n = less ? none + e.sin : n, det = less ? none + e.det : det;
    }
    LatticeOffset<Real> nearest(s, t, g11_, g12_, g22_);
    nearest.reduce();
    s = nearest.s, t = nearest.t;
    const Vector g1 = s * g11_ + t * g12_, g2 = s * g12_ + t * g22_;
    // The second nearest may be the same element with other repeats.
    second = least(second, first + g11_ - 2 * abs(g1));
    second = least(second, first + g22_ - 2 * abs(g2));
    second = least(second, first + g33 - 2 * abs(g1 - g2));
    const Vector d = squareRoots(greatest(first, none));
    const Vector w = loaded(&level->w[from]), radius = loaded(&level->radius[from]);
    const Vector far_a = loaded(&level->far_a[from]), far_b = loaded(&level->far_b[from]);
    const Vector rho = far_a * swing_a + far_b * swing_b + shift;
    flat += w * greatest(d - rho - loaded(&level->spread[from]), none);
    // A line bounds the distance to the nearest element; `range` is its greatest change in the
    // boxes.
    Lines line;
    const Vector per = d > tiny ? one / greatest(d, tiny) : none;
    line.ux = (s * u0x_ + t * u1x_) * per, line.uy = (s * u0y_ + t * u1y_) * per;
    line.vx = c * line.ux + n * line.uy, line.vy = det * (c * line.uy - n * line.ux);
    Vector range = abs(line.ux * ax0 + line.uy * ay0) + abs(line.ux * ax1 + line.uy * ay1) +
                   abs(line.vx * bx0 + line.vy * by0) + abs(line.vx * bx1 + line.vy * by1) +
                   radius * farther;
    if (turns) {
      line.turn_a = line.uy * (pa.cos * ax + pa.sin * ay) - line.ux * (pa.cos * ay - pa.sin * ax);
      line.turn_b = line.vy * (pb.cos * bx + pb.sin * by) - line.vx * (pb.cos * by - pb.sin * bx);
      range += abs(line.turn_a) * most_a + abs(line.turn_b) * most_b;
    }
    line.middle = d - bend_a * far_a - bend_b * far_b;
    // `others` bounds the distances of the other elements. The chord of the lesser of both starts
    // at 0.
    const Vector others = greatest(squareRoots(greatest(second, none)) - rho - radius, none);
    const Vector low = greatest(line.middle - range, none), high = line.middle + range;
    const Vector chord = least(greatest((others - low) / greatest(high - low, tiny), none), one);
    const Vector share = line.middle > none ? w * chord : none;
    const auto meets = line.middle < range;
    line.middle = w * least(low, others) + share * (line.middle - low);
    line.ux *= share, line.uy *= share, line.vx *= share, line.vy *= share;
    line.turn_a *= share, line.turn_b *= share;
    far.add(line, !meets), close.add(line, meets);
  }
  // Edges that may meet in the boxes count only if they raise the bound.
  const double level_bound = seam_->a == seam_->b ? ownFlat(*level, a) : sumOf(flat);
  const Pair without = sumOfLines(far, a, b);
  far.add(close, none == none);
  Pair pair = sumOfLines(far, a, b);
  const double bound = std::max({0.0, level_bound - rounding_, without.least, pair.least});
  if (pair.middle - pair.steepness() / 2 < without.middle - without.steepness() / 2) pair = without;
  pair.least = bound;
  spent += static_cast<double>(level->w.size() * (4 + images_.size()));
  return pair;
}

}  // namespace seamwise
