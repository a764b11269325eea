#include "symmetry/mirror_search.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/sort_by.h"
#include "symmetry/symmetry.h"
#include "tuning/symmetry.h"

namespace seamwise {
namespace {

using EvenPoints = std::array<Vec2, Outline::kEven>;

// Computes the outline's even points relative to their centre, which is returned.
Vec2 centred(const Outline& outline, EvenPoints& points) {
  Vec2 centre = Vec2::Zero();
  for (const Vec2& p : outline.even()) centre += p / Outline::kEven;
  for (int k = 0; k < Outline::kEven; ++k) points[k] = outline.even()[k] - centre;
  return centre;
}

// Solves every cyclic shift of the reversed arc-length correspondence in closed form and returns
// the local minima.
std::vector<MirrorStart> startMaps(const Outline& a, const Outline& b) {
  constexpr int n = Outline::kEven;
  EvenPoints p, q;
  const Vec2 from = centred(a, p), to = centred(b, q);
  double energy = 0;
  for (int k = 0; k < n; ++k) energy += p[k].squaredNorm() + q[k].squaredNorm();
  EvenPoints product;
  std::array<double, n> square;
  std::array<Vec2, 2 * n> backwards;  // twice round, so that every shift is contiguous
  for (int k = 0; k < 2 * n; ++k) backwards[k] = q[(2 * n - 1 - k) % n];
  for (int shift = 0; shift < n; ++shift) {
    double re = 0, im = 0;
    for (int k = 0; k < n; ++k) {
      const Vec2 &u = p[k], &v = backwards[n - 1 - shift + k];
      re += u.x() * v.x() - u.y() * v.y();
      im += u.x() * v.y() + u.y() * v.x();
    }
    product[shift] = {re, im};
    square[shift] = (energy - 2 * product[shift].norm()) / n;
  }
  std::vector<MirrorStart> starts;
  for (int shift = 0; shift < n; ++shift) {
    if (square[shift] > square[(shift + n - 1) % n] || square[shift] > square[(shift + 1) % n])
      continue;
    RigidMotion map{std::atan2(-product[shift].y(), -product[shift].x()), Vec2::Zero(), true};
    map.shift = to - map(from);
    starts.push_back({map, std::sqrt(std::max(0.0, square[shift]))});
  }
  sortBy(starts, [](const MirrorStart& start) { return start.rms; });
  if (starts.size() > SymmetryTuning::kMostStarts) starts.resize(SymmetryTuning::kMostStarts);
  return starts;
}

bool sameMap(const Outline& a, const RigidMotion& x, const RigidMotion& y) {
  for (const Vec2& p :
       {a.even()[0], a.even()[Outline::kEven / 3], a.even()[2 * Outline::kEven / 3]})
    if ((x(p) - y(p)).norm() > 2 * kMirrorTolerance) return false;
  return true;
}

}  // namespace

MirrorSearch::MirrorSearch(const Outline& a, const Outline& b) : a_(&a), b_(&b) {
  if (std::abs(a.length() - b.length()) > 2 + 0.02 * a.length() ||
      std::abs(a.area() - b.area()) > 2 * kMirrorTolerance * a.length())
    return;
  starts_ = startMaps(a, b);
  const double limit = 0.75 * a.length() / Outline::kEven + 2 * kMirrorTolerance;
  const auto pruned = std::find_if(starts_.begin(), starts_.end(),
                                   [&](const MirrorStart& start) { return start.rms > limit; });
  starts_.erase(pruned, starts_.end());
}

bool MirrorSearch::advance() {
  if (next_ == starts_.size()) return false;
  const MirrorRegistration registration =
      registerMirror(*a_, *b_, starts_[next_++].map, kMirrorTolerance);
  const bool known = std::any_of(
      found_.begin(), found_.end(),
      [&](const MirrorRegistration& other) { return sameMap(*a_, registration.map, other.map); });
  if (registration.residual <= kMirrorTolerance && !known) found_.push_back(registration);
  return true;
}

std::vector<MirrorRegistration> MirrorSearch::take() {
  sortBy(found_, [](const MirrorRegistration& registration) { return registration.residual; });
  return std::move(found_);
}

std::vector<MirrorRegistration> findMirrors(const Outline& a, const Outline& b) {
  MirrorSearch search(a, b);
  while (search.advance()) {
  }
  return search.take();
}

MirrorRegistration bestMirror(const Outline& a, const Outline& b) {
  MirrorRegistration best{{}, std::numeric_limits<double>::infinity()};
  for (const MirrorStart& start : startMaps(a, b)) {
    const MirrorRegistration registration = registerMirror(a, b, start.map);
    if (registration.residual < best.residual) best = registration;
  }
  return best;
}

}  // namespace seamwise
