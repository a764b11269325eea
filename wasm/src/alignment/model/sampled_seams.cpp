#include "alignment/model/sampled_seams.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment/model/leader_order.h"
#include "alignment/model/sampled_seams_lanes.h"
#include "tuning/search.h"

namespace seamwise {
namespace {

constexpr double kRightAngle = 1e-12;  ///< greatest cosine of a right angle

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
  rectangular_ = std::abs(u1.dot(u2)) < kRightAngle * u1.squaredNorm();
  g11_ = real(u1.squaredNorm()), g12_ = real(rectangular_ ? 0 : u1.dot(u2));
  g22_ = real(u2.squaredNorm());
  for (const seamwise::Element& e : group.elements()) {
    const Mat2 m = (to_reduced * e.A * basis).array().round();
    const Vec2 a = to_reduced * e.a;
    const Element reduced{real(m(0, 0)),   real(m(0, 1)),   real(m(1, 0)),
                          real(m(1, 1)),   real(a.x()),     real(a.y()),
                          real(e.A(0, 0)), real(e.A(1, 0)), real(e.mirrored ? -1 : 1),
                          m(0, 0) == 0};
    all_.each.push_back(reduced);
    (e.mirrored ? improper_ : proper_).each.push_back(reduced);
  }
  for (Elements* elements : {&all_, &proper_, &improper_}) elements->pack();
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
      samples.count = std::min(
          edges, std::max(SearchTuning::kFewestSamples, static_cast<int>(length / spacing) + 1));
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
    measure(samples);
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
  const auto map = [](const Mat2& of, const Vec2& shift) {
    const auto real = [](double v) { return static_cast<Real>(v); };
    return typename Pose::Map{real(of(0, 0)), real(of(0, 1)),  real(of(1, 0)),
                              real(of(1, 1)), real(shift.x()), real(shift.y())};
  };
  Pose pose{map(m, t), {}, static_cast<Real>(c), static_cast<Real>(s)};
  pose.lattice = shape_ == Chamber::Shape::kCell
                     ? pose.chamber
                     : map(to_lattice_ * m, to_lattice_ * (t - pose_offset_));
  return pose;
}

/// Same as offset().squared() on a rectangular lattice, with the nearest point in each coordinate.
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
double SampledSeams<Real>::foldedSum(int seam, const Pose& a, const Pose& b) const {
  return sumOver(seam, a, b,
                 [this](int, const Placed& p) { return squaredInChamber<triangle>(p); });
}

/// Sum of w d, each sample with its nearest element. [cm2]
template <class Real>
double SampledSeams<Real>::sum(int seam, const Pose& a, const Pose& b) const {
  const auto nearest = [&](const auto& squared) {
    return sumOver(seam, a, b, [&](int of, const Placed& p) {
      Vector best = Vector{} + std::numeric_limits<Real>::max();
      for (const Element& e : seams_[of].elements->each) best = least(best, squared(p, e));
      return greatest(best, Vector{});
    });
  };
  if constexpr (sizeof(Real) == sizeof(float)) {
    if (Chamber::isTriangle(shape_)) return foldedSum<true>(seam, a, b);
    if (shape_ != Chamber::Shape::kCell) return foldedSum<false>(seam, a, b);
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
[[gnu::always_inline]] inline double SampledSeams<Real>::sumOver(int seam, const Pose& a,
                                                                 const Pose& b,
                                                                 const Squared& squared) const {
  const Samples& samples = seams_[seam];
  Vector all{};
  for (int from = samples.from; from < samples.from + samples.count; from += kLanes)
    all += loaded(&w_[from]) * squareRoots(squared(seam, placed(from, a.chamber, b.chamber)));
  return sumOf(all);
}

template <class Real>
double SampledSeams<Real>::cost(int seam, const Pose& a, const Pose& b, double slack) const {
  return chosen(seam, a, b, slack).cost;
}

template <class Real>
double SampledSeams<Real>::sampleCost() const {
  // Placing a sample on the print takes about as long as four elements, and folding as long as one
  // or two.
  return SearchTuning::kPlacingWork +
         (shape_ == Chamber::Shape::kCell
              ? static_cast<double>(all_.each.size())
              : SearchTuning::kFoldWork * static_cast<double>(cosets_.size()));
}

template class SampledSeams<float>;
template class SampledSeams<double>;

}  // namespace seamwise
