#include "alignment/sampled_seams.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace seamwise {
namespace {

constexpr double kFloor = 0.02;  ///< cm: distances below it are weighted as if they were it
constexpr int kFewest = 4;       ///< samples a seam
constexpr double kLeak =
    0.1;  ///< share of a distance that counts inside the slack: ties go to the better

/// What a seam misses by beyond its limit counts so many times more.
constexpr double kHard = 6;
constexpr double kLeft =
    0.15;  ///< share of what lies within the slack that shaping leaves as a rule
constexpr double kWorthShaping =
    0.7;  ///< share of a mismatch that is left where shaping is worth it

constexpr double kSquare = 1e-12;  ///< cosine of an angle that is a right one

using internal::roundNear;

/// Per leader its place in an order that keeps neighbours close (Cuthill & McKee 1969, reversed).
std::vector<int> ranked(const MatchProblem& problem) {
  const std::size_t count = problem.leaders.size();
  std::vector<std::vector<int>> neighbours(count);
  for (const MatchSeam& seam : problem.seams) {
    neighbours[seam.a].push_back(seam.b);
    neighbours[seam.b].push_back(seam.a);
  }
  const auto fewer = [&](int l, int k) { return neighbours[l].size() < neighbours[k].size(); };
  std::vector<int> by_degree(count), order, ranks(count, -1);
  std::iota(by_degree.begin(), by_degree.end(), 0);
  std::stable_sort(by_degree.begin(), by_degree.end(), fewer);
  for (auto& around : neighbours) std::stable_sort(around.begin(), around.end(), fewer);
  const auto reach = [&](int leader) {
    if (ranks[leader] >= 0) return;
    ranks[leader] = static_cast<int>(count - 1 - order.size());
    order.push_back(leader);
  };
  for (const int start : by_degree) {
    const std::size_t from = order.size();
    reach(start);
    for (std::size_t k = from; k < order.size(); ++k)
      for (const int next : neighbours[order[k]]) reach(next);
  }
  return ranks;
}

}  // namespace

template <class Real>
SampledSeams<Real>::SampledSeams(const MatchProblem& problem, double spacing)
    : ranks_(ranked(problem)) {
  const WallpaperGroup& group = problem.group;
  const auto& [u1, u2] = group.reducedBasis();
  const Mat2 basis = (Mat2() << u1, u2).finished();
  const Mat2 to_reduced = to_pose_ = basis.inverse();
  const auto real = [](double v) { return static_cast<Real>(v); };
  u0x_ = real(u1.x()), u0y_ = real(u1.y()), u1x_ = real(u2.x()), u1y_ = real(u2.y());
  rectangular_ = std::abs(u1.dot(u2)) < kSquare * u1.squaredNorm();
  g11_ = real(u1.squaredNorm()), g12_ = real(rectangular_ ? 0 : u1.dot(u2));
  g22_ = real(u2.squaredNorm());
  for (const seamwise::Element& e : group.elements()) {
    const Mat2 m = (to_reduced * e.A * basis).array().round();
    const Vec2 a = to_reduced * e.a;
    const Element reduced{real(m(0, 0)),   real(m(0, 1)),   real(m(1, 0)),
                          real(m(1, 1)),   real(a.x()),     real(a.y()),
                          real(e.A(0, 0)), real(e.A(1, 0)), real(e.mirrored ? -1 : 1),
                          m(0, 0) == 0};
    all_.push_back(reduced);
    (e.mirrored ? improper_ : proper_).push_back(reduced);
  }
  if (sizeof(Real) == sizeof(float) && !problem.continuous_only && group.carriesSingle()) {
    const Chamber chamber = Chamber::of(group);
    shape_ = chamber.shape;
    to_pose_ = chamber.to, pose_offset_ = chamber.offset;
    to_lattice_ = to_reduced * chamber.to.inverse();
    square0_ = real(chamber.square0), square1_ = real(chamber.square1);
    for (std::size_t k = 1; k < chamber.cosets.size(); ++k) {
      const auto& [m, a] = chamber.cosets[k];
      cosets_.push_back(
          {real(m(0, 0)), real(m(0, 1)), real(m(1, 0)), real(m(1, 1)), real(a.x()), real(a.y())});
    }
  }
  for (const Leader& leader : problem.leaders) centres_.push_back(leader.centre);
  for (const MatchSeam& seam : problem.seams) {
    Samples samples;
    samples.from = static_cast<int>(w_.size());
    samples.elements = !problem.continuous_only ? &all_ : seam.reversing ? &improper_ : &proper_;
    const int edges = static_cast<int>(seam.w.size());
    double length = 0;
    for (const Vec2& d : seam.da) length += d.norm();
    samples.count = edges;
    if (spacing > 0)
      samples.count = std::min(edges, std::max(kFewest, static_cast<int>(length / spacing) + 1));
    for (int k = 0; k < samples.count; ++k) {
      const int first = k * edges / samples.count, last = (k + 1) * edges / samples.count;
      double w = 0;
      for (int i = first; i < last; ++i) w += seam.w[i];
      const int middle = (first + last) / 2;
      const Vec2 a = seam.pa[middle] - centres_[seam.a], b = seam.pb[middle] - centres_[seam.b];
      ax_.push_back(static_cast<Real>(a.x())), ay_.push_back(static_cast<Real>(a.y()));
      bx_.push_back(static_cast<Real>(b.x())), by_.push_back(static_cast<Real>(b.y()));
      w_.push_back(static_cast<Real>(w));
      weight_ += w;
    }
    samples.limit = seam.limit * seam.weight;
    for (auto* array : {&ax_, &ay_, &bx_, &by_, &w_})
      array->resize((array->size() + kLanes - 1) / kLanes * kLanes, 0);
    seams_.push_back(samples);
  }
}

template <class Real>
typename SampledSeams<Real>::Pose SampledSeams<Real>::pose(int leader, const Alignment& at) const {
  const double c = std::cos(at.angle), s = std::sin(at.angle);
  const Mat2 m = to_pose_ * (Mat2() << c, s, -s, c).finished();
  Vec2 t = m * (centres_[leader] - at.translation) + pose_offset_;
  t -= t.array().round().matrix();  // lattice vectors change nothing, and small numbers are exact
  return {static_cast<Real>(m(0, 0)),
          static_cast<Real>(m(0, 1)),
          static_cast<Real>(m(1, 0)),
          static_cast<Real>(m(1, 1)),
          static_cast<Real>(t.x()),
          static_cast<Real>(t.y()),
          c,
          s};
}

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
    int from, const Pose& a, const Pose& b) const {
  const Vector ax = loaded(&ax_[from]), ay = loaded(&ay_[from]);
  const Vector bx = loaded(&bx_[from]), by = loaded(&by_[from]);
  return {a.m00 * ax + a.m01 * ay + a.t0, a.m10 * ax + a.m11 * ay + a.t1,
          b.m00 * bx + b.m01 * by + b.t0, b.m10 * bx + b.m11 * by + b.t1};
}

template <class Real>
[[gnu::always_inline]] inline typename SampledSeams<Real>::Offset SampledSeams<Real>::reduced(
    const Vector& s0, const Vector& t0) const {
  Offset o;
  o.s = s0 - roundNear(s0), o.t = t0 - roundNear(t0);
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

/// As offset().squared() on a rectangular lattice, whose nearest point is that of each coordinate.
template <class Real>
[[gnu::always_inline]] inline typename SampledSeams<Real>::Vector
SampledSeams<Real>::squaredOnRectangles(const Placed& p, const Element& e) const {
  const Vector s0 = p.x0 - ((e.swaps ? e.m01 * p.y1 : e.m00 * p.y0) + e.a0);
  const Vector t0 = p.x1 - ((e.swaps ? e.m10 * p.y0 : e.m11 * p.y1) + e.a1);
  const Vector s = s0 - roundNear(s0), t = t0 - roundNear(t0);
  return s * (s * g11_) + t * (t * g22_);
}

/// The least squared distance of both sides, by folding them into the chamber.
template <class Real>
template <bool triangle>
[[gnu::always_inline]] inline typename SampledSeams<Real>::Vector
SampledSeams<Real>::squaredInChamber(const Placed& p) const {
  using Point = Folded<triangle, Vector>;
  const Point x(shape_, p.x0, p.x1);
  Vector best = x.squaredTo(Point(shape_, p.y0, p.y1), shape_, square0_, square1_);
  for (const Coset& c : cosets_) {
    const Point y(shape_, c.m00 * p.y0 + c.m01 * p.y1 + c.a0, c.m10 * p.y0 + c.m11 * p.y1 + c.a1);
    best = least(best, x.squaredTo(y, shape_, square0_, square1_));
  }
  return best;
}

template <class Real>
template <bool triangle>
typename SampledSeams<Real>::Sums SampledSeams<Real>::foldedSums(int seam, const Pose& a,
                                                                 const Pose& b,
                                                                 double slack) const {
  return sumsOver(seam, a, b, slack,
                  [this](int, const Placed& p) { return squaredInChamber<triangle>(p); });
}

template <class Real>
typename SampledSeams<Real>::Sums SampledSeams<Real>::sums(int seam, const Pose& a, const Pose& b,
                                                           double slack) const {
  const auto nearest = [&](const auto& squared) {
    return sumsOver(seam, a, b, slack, [&](int of, const Placed& p) {
      Vector best = Vector{} + std::numeric_limits<Real>::max();
      for (const Element& e : *seams_[of].elements) best = least(best, squared(p, e));
      return greatest(best, Vector{});
    });
  };
  if constexpr (sizeof(Real) == sizeof(float)) {
    if (Chamber::isTriangle(shape_)) return foldedSums<true>(seam, a, b, slack);
    if (shape_ != Chamber::Shape::kCell) return foldedSums<false>(seam, a, b, slack);
  }
  return rectangular_ ? nearest([this](const Placed& p, const Element& e) {
    return squaredOnRectangles(p, e);
  })
                      : nearest([this](const Placed& p, const Element& e) {
                          return offset(p, e).squared();
                        });
}

template <class Real>
template <class Squared>
[[gnu::always_inline]] inline typename SampledSeams<Real>::Sums SampledSeams<Real>::sumsOver(
    int seam, const Pose& a, const Pose& b, double slack, const Squared& squared) const {
  const Samples& samples = seams_[seam];
  const Real allowance = static_cast<Real>(slack);
  const Vector none{};
  Vector all{}, beyond{};
  for (int from = samples.from; from < samples.from + samples.count; from += kLanes) {
    const Vector d = squareRoots(squared(seam, placed(from, a, b))), w = loaded(&w_[from]);
    all += w * d;
    beyond += w * greatest(d - allowance, none);
  }
  return {sumOf(all), sumOf(beyond)};
}

template <class Real>
typename SampledSeams<Real>::Excess SampledSeams<Real>::excess(int seam, const Sums& of,
                                                               double slack) const {
  const double limit = seams_[seam].limit;
  if (of.all <= limit) return Excess::kNone;
  const double shaped = of.beyond + kLeft * of.all;
  if (slack > 0 && shaped <= kWorthShaping * of.all)
    return shaped <= limit ? Excess::kNone : Excess::kOfBeyond;
  return Excess::kOfAll;
}

template <class Real>
double SampledSeams<Real>::cost(int seam, const Pose& a, const Pose& b, double slack) const {
  const Sums of = sums(seam, a, b, slack);
  double cost = slack > 0 ? of.beyond + kLeak * of.all : of.all;
  switch (excess(seam, of, slack)) {
    case Excess::kOfAll:
      return cost + kHard * (of.all - seams_[seam].limit);
    case Excess::kOfBeyond:
      return cost + kHard * (of.beyond + kLeft * of.all - seams_[seam].limit);
    default:
      return cost;
  }
}

template <class Real>
double SampledSeams<Real>::sampleCost() const {
  // placing a sample on the print takes about as long as four elements, folding as one or two
  return 4.0 + (shape_ == Chamber::Shape::kCell ? static_cast<double>(all_.size())
                                                : 1.5 * static_cast<double>(cosets_.size()));
}

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
  double within = slack > 0 ? kLeak : 1, outside = slack > 0 ? 1 + kLeak : 1;
  if (std::isfinite(samples.limit)) {
    const Excess broken = excess(seam, sums(seam, at_a, at_b, slack), slack);
    if (broken == Excess::kOfAll) within += kHard, outside += kHard;
    if (broken == Excess::kOfBeyond) within += kLeft * kHard, outside += (1 + kLeft) * kHard;
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

template class SampledSeams<float>;
template class SampledSeams<double>;

}  // namespace seamwise
