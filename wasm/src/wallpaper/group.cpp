#include "wallpaper/group.h"

#include <Eigen/LU>
#include <algorithm>

#include "base/decimal.h"
#include "wallpaper/lattice.h"

namespace seamwise {
namespace {

Mat2 integerMatrix(const std::array<int, 4>& m) {
  return (Mat2() << m[0], m[1], m[2], m[3]).finished();
}

/// The element in centimetres for the basis B = [w1 w2]. Its linear part is orthogonal up to
/// rounding.
Element inCentimetres(const LatticeElement& e, const Mat2& basis) {
  const Mat2 A = basis * integerMatrix(e.m) * basis.inverse();
  Element out;
  out.mirrored = e.det() < 0;
  const double sign = out.mirrored ? -1 : 1;
  Vec2 first = (A.col(0) - sign * perp(A.col(1))).normalized();
  for (double& x : first) {
    if (std::abs(x) < 1e-15) x = 0;
  }
  out.A.col(0) = first;
  out.A.col(1) = sign * perp(first);
  out.angle = directionOf(first);
  out.a = basis * Vec2(e.a[0], e.a[1]);
  return out;
}

}  // namespace

Outcome<WallpaperGroup> WallpaperGroup::make(std::string_view name, const Vec2& w1,
                                             const Vec2& w2) {
  const GroupData* data = findGroup(name);
  if (data == nullptr) {
    std::string known;
    for (const GroupData& group : wallpaperGroups()) {
      known += (known.empty() ? "" : ", ") + std::string(group.name);
    }
    return Error{Failure::kGroupUnknown,
                 "print group '" + std::string(name) + "' is unknown: choose one of " + known, -1,
                 -1};
  }
  const auto lattice = checkedLattice(*data, w1, w2);
  if (!lattice.ok()) return lattice.error();
  const std::vector<LatticeElement> all = cosets(*data);
  if (static_cast<int>(all.size()) != data->order) {
    return Error{Failure::kInternal,
                 "the table of wallpaper groups is wrong for " + std::string(data->name), -1, -1};
  }

  WallpaperGroup group;
  group.data_ = data;
  group.w_ = lattice.value();
  group.reduced_ = lagrangeReduced(group.w_[0], group.w_[1]);
  const auto& [r1, r2] = group.reduced_;
  Mat2 basis, reduced;
  basis.col(0) = group.w_[0];
  basis.col(1) = group.w_[1];
  reduced.col(0) = r1;
  reduced.col(1) = r2;
  group.to_reduced_ = reduced.inverse();
  group.gram11_ = r1.squaredNorm();
  group.gram12_ = r1.dot(r2);
  group.gram22_ = r2.squaredNorm();

  // The change of basis is a unimodular integer matrix, so rounding makes it exact.
  const Mat2 to_basis = (basis.inverse() * reduced).array().rint().matrix();
  const Mat2 from_basis = (group.to_reduced_ * basis).array().rint().matrix();
  for (const LatticeElement& e : all) {
    group.elements_.push_back(inCentimetres(e, basis));
    const Mat2 m = from_basis * integerMatrix(e.m) * to_basis;
    const Vec2 a = from_basis * Vec2(e.a[0], e.a[1]);
    group.reduced_elements_.push_back({m(0, 0), m(0, 1), m(1, 0), m(1, 1), a.x(), a.y()});
  }
  return group;
}

WallpaperGroup WallpaperGroup::joining(bool continuous_only) const {
  if (!continuous_only) return *this;
  // Every group with rotations has its origin at a rotation centre, as the five result groups do.
  const auto turns = std::count_if(elements_.begin(), elements_.end(),
                                   [](const Element& e) { return !e.mirrored; });
  return make("p" + decimal(turns), w1(), w2()).value();
}

}  // namespace seamwise
