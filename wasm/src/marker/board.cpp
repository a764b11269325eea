#include "marker/board.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wallpaper/lattice.h"

namespace seamwise {
namespace {

constexpr int kMostMultiple = 24;       ///< greatest multiple of a basis vector along an axis
constexpr double kLongestPeriod = 400;  // cm

/// The shortest primitive lattice vector along an axis, as multiples of the basis.
std::optional<Dot> axisVector(const Vec2& a, const Vec2& b, int axis) {
  std::optional<Dot> best;
  double shortest = kLongestPeriod;
  for (int i = -kMostMultiple; i <= kMostMultiple; ++i) {
    for (int j = -kMostMultiple; j <= kMostMultiple; ++j) {
      const Vec2 v = i * a + j * b;
      const bool is_along = std::abs(v[1 - axis]) < 1e-7 && v[axis] > 1e-3;
      if (!is_along || v[axis] >= shortest - 1e-9) continue;
      shortest = v[axis];
      best = Dot{i, j};
    }
  }
  return best;
}

/// A vector that forms a basis with the primitive vector m.
Dot partnerOf(Dot m) {
  // The extended Euclidean algorithm gives x i + y j = gcd = 1, so (i, j) and (-y, x) have
  // determinant 1.
  int r0 = m.i, r1 = m.j, x0 = 1, x1 = 0, y0 = 0, y1 = 1;
  while (r1 != 0) {
    const int q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    x0 = std::exchange(x1, x0 - q * x1);
    y0 = std::exchange(y1, y0 - q * y1);
  }
  return r0 < 0 ? Dot{y0, -x0} : Dot{-y0, x0};
}

}  // namespace

Board Board::ofLattice(const Vec2& w1, const Vec2& w2, double least) {
  const auto [a, b] = lagrangeReduced(w1, w2);
  Vec2 along, up;
  if (const auto across = axisVector(a, b, 0)) {
    const Dot other = partnerOf(*across);
    along = {(across->i * a + across->j * b).x(), 0};  // removes rounding from a level vector
    up = other.i * a + other.j * b;
  } else {
    const bool first = std::abs(a.x()) * b.norm() >= std::abs(b.x()) * a.norm();
    along = first ? a : b;
    up = first ? b : a;
  }
  if (along.x() < 0) along = -along;
  if (cross(along, up) < 0) up = -up;
  const auto times = [&](const Vec2& v) {
    return std::max(1.0, std::ceil(least / v.norm() - 1e-9));
  };
  along *= times(along);
  up -= std::nearbyint(up.dot(along) / along.squaredNorm()) * along;
  up *= times(up);
  up -= std::nearbyint(up.dot(along) / along.squaredNorm()) * along;
  return {along, up};
}

std::optional<double> latticePeriod(const Vec2& w1, const Vec2& w2, bool along_warp) {
  const auto [a, b] = lagrangeReduced(w1, w2);
  const auto found = axisVector(a, b, along_warp ? 1 : 0);
  if (!found) return std::nullopt;
  return (found->i * a + found->j * b)[along_warp ? 1 : 0];
}

}  // namespace seamwise
