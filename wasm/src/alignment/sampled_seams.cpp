#include "alignment/sampled_seams.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment/leader_order.h"
#include "alignment/sampled_seams_lanes.h"

namespace seamwise {
namespace {

constexpr int kFewest = 4;         ///< samples a seam
constexpr double kSquare = 1e-12;  ///< cosine of an angle that is a right one

}  // namespace

template <class Real>
SampledSeams<Real>::SampledSeams(const MatchProblem& problem, double spacing)
    : ranks_(rankedLeaders(problem)) {
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

/// As offset().squared() on a rectangular lattice, whose nearest point is that of each coordinate.
template <class Real>
[[gnu::always_inline]] inline typename SampledSeams<Real>::Vector
SampledSeams<Real>::squaredOnRectangles(const Placed& p, const Element& e) const {
  const Vector s0 = p.x0 - ((e.swaps ? e.m01 * p.y1 : e.m00 * p.y0) + e.a0);
  const Vector t0 = p.x1 - ((e.swaps ? e.m10 * p.y0 : e.m11 * p.y1) + e.a1);
  const Vector s = s0 - internal::roundNear(s0), t = t0 - internal::roundNear(t0);
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
  const double shaped = of.beyond + kLeftByShaping * of.all;
  if (slack > 0 && shaped <= kWorthShaping * of.all)
    return shaped <= limit ? Excess::kNone : Excess::kOfBeyond;
  return Excess::kOfAll;
}

template <class Real>
double SampledSeams<Real>::cost(int seam, const Pose& a, const Pose& b, double slack) const {
  const Sums of = sums(seam, a, b, slack);
  double cost = slack > 0 ? of.beyond + SeamCosts::kLeak * of.all : of.all;
  switch (excess(seam, of, slack)) {
    case Excess::kOfAll:
      return cost + SeamCosts::kHard * (of.all - seams_[seam].limit);
    case Excess::kOfBeyond:
      return cost + SeamCosts::kHard * (of.beyond + kLeftByShaping * of.all - seams_[seam].limit);
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

template class SampledSeams<float>;
template class SampledSeams<double>;

}  // namespace seamwise
