#pragma once
#include <array>
#include <utility>
#include <vector>

#include "geometry/curve.h"

// Path edges for tests. [cm]
namespace seamwise::testing {

/// Control points of a cubic before and after a parameter (de Casteljau).
inline std::pair<std::array<Vec2, 4>, std::array<Vec2, 4>> halves(const std::array<Vec2, 4>& p,
                                                                  double t) {
  const auto between = [t](const Vec2& a, const Vec2& b) -> Vec2 { return (1 - t) * a + t * b; };
  const Vec2 ab = between(p[0], p[1]), bc = between(p[1], p[2]), cd = between(p[2], p[3]);
  const Vec2 abc = between(ab, bc), bcd = between(bc, cd), at = between(abc, bcd);
  return {{p[0], ab, abc, at}, {at, bcd, cd, p[3]}};
}

/// A line, a quadratic curve or a cubic, drawn as a path of so many cubics.
inline Curve asPath(const Curve& curve, int parts) {
  const std::vector<Vec2> own = curve.points();
  const Vec2 a = own.front(), b = own.back();
  const Vec2 first = own.size() == 4   ? own[1]
                     : own.size() == 3 ? Vec2((a + 2 * own[1]) / 3)
                                       : Vec2((2 * a + b) / 3);
  const Vec2 second = own.size() == 4   ? own[2]
                      : own.size() == 3 ? Vec2((2 * own[1] + b) / 3)
                                        : Vec2((a + 2 * b) / 3);
  std::array<Vec2, 4> rest{a, first, second, b};
  std::vector<Vec2> points{a};
  for (int left = parts; left > 1; --left) {
    const auto [cubic, more] = halves(rest, 1.0 / left);
    points.insert(points.end(), cubic.begin() + 1, cubic.end());
    rest = more;
  }
  points.insert(points.end(), rest.begin() + 1, rest.end());
  return Curve::path(points);
}

/// Straight lines from corner to corner, as one path.
inline Curve polyline(const std::vector<Vec2>& corners) {
  std::vector<Vec2> points{corners.front()};
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const Vec2 &a = corners[k], &b = corners[k + 1];
    points.insert(points.end(), {(2 * a + b) / 3, (a + 2 * b) / 3, b});
  }
  return Curve::path(points);
}

}  // namespace seamwise::testing
