#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace seamwise {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;
using Polyline = std::vector<Vec2>;

inline constexpr double kPi = std::numbers::pi;

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// v turned a quarter counter-clockwise.
inline Vec2 perp(const Vec2& v) { return {-v.y(), v.x()}; }

/// The unit vector of an angle; directionOf is its inverse, in [-pi, pi].
inline Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

inline double directionOf(const Vec2& v) { return std::atan2(v.y(), v.x()); }

inline Mat2 rotation(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Mat2() << c, -s, s, c).finished();
}

/// The turn that brings the direction of `from` to that of `to`, counter-clockwise, in [-pi, pi].
inline double turnBetween(const Vec2& from, const Vec2& to) {
  return std::atan2(cross(from, to), from.dot(to));
}

/// The turn of the polyline u, v, w at v, counter-clockwise, in [-pi, pi].
inline double turnAt(const Vec2& u, const Vec2& v, const Vec2& w) {
  return turnBetween(v - u, w - v);
}

/// Area of a triangle, positive when a, b, c are counter-clockwise. [cm2]
inline double triangleArea(const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(b - a, c - a) / 2;
}
/// The same for a triangle of a mesh, whose vertex v is at x[v].
inline double triangleArea(const std::vector<Vec2>& x, const std::array<int, 3>& triangle) {
  return triangleArea(x[triangle[0]], x[triangle[1]], x[triangle[2]]);
}

/// The equivalent angle in (-pi, pi].
inline double wrapAngle(double angle) {
  const double a = angle - 2 * kPi * std::nearbyint(angle / (2 * kPi));
  return a <= -kPi ? a + 2 * kPi : a;
}

}  // namespace seamwise
