#include "photo/base/map_inverse.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

namespace {
constexpr int kLensNewtonSteps = 8;       // three are enough for |k| <= 0.1
constexpr double kDerivativeStep = 1e-3;  // share of a cell, to both sides

Eigen::RowVector3d rowCross(const Vec3& a, const Vec3& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}
}  // namespace

MapInverse::MapInverse(const LatticeMap& map)
    : lens_(map.lens), middle_(map.middle), radius_(map.radius) {
  const Mat3& h = map.homography;
  const Vec3 a = h.col(0), b = h.col(1), c = h.col(2);
  back_.row(0) = rowCross(b, c);  // up to a factor, which homographies allow
  back_.row(1) = rowCross(c, a);
  back_.row(2) = rowCross(a, b);
}

Vec2 MapInverse::operator()(const Vec2& p) const {
  const Vec2 off = p - middle_;
  const double seen = off.norm() / radius_;
  double flat = seen;
  for (int step = 0; step < kLensNewtonSteps; ++step) {
    const double slope = 1 + 3 * lens_ * flat * flat;
    if (slope <= 0.1) break;  // outside the range of such a lens
    flat -= (flat + lens_ * flat * flat * flat - seen) / slope;
  }
  const Vec2 q = middle_ + (seen > 0 ? flat / seen : 1.0) * off;
  const Vec3 u = back_ * Vec3(q.x(), q.y(), 1);
  return {u.x() / u.z(), u.y() / u.z()};
}

Mat2 derivative(const LatticeMap& map, const Vec2& u) {
  const Vec2 right(kDerivativeStep, 0), up(0, kDerivativeStep);
  Mat2 d;
  d.col(0) = (map(u + right) - map(u - right)) / (2 * kDerivativeStep);
  d.col(1) = (map(u + up) - map(u - up)) / (2 * kDerivativeStep);
  return d;
}

double cellSize(const LatticeMap& map) {
  const Mat2 d = derivative(map, MapInverse(map)(map.middle));
  return std::sqrt(std::abs(cross(d.col(0), d.col(1))));
}

double longerRepeat(const LatticeMap& map) {
  const Mat2 d = derivative(map, MapInverse(map)(map.middle));
  return std::max(d.col(0).norm(), d.col(1).norm());
}

}  // namespace seamwise
