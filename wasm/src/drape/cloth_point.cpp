#include "drape/cloth_point.h"

namespace seamwise {

Vec3 ClothPoint::at(const Positions& x) const {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) sum[c] += weights[k] * x[vertices[k]][c];
  return sum;
}

void ClothPoint::addTo(Positions& y, const Vec3& v) const {
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) y[vertices[k]][c] += weights[k] * v[c];
}

Vec3 normalOf(const std::array<int, 3>& t, const Positions& x) {
  const Vec3 n = crossProduct(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]);
  const double far = length(n);
  return far > 0 ? Vec3(n / far) : Vec3(0, 0, 0);
}

ClothPoint footOf(const Vec3& p, const std::array<int, 3>& t, const Positions& x) {
  const Vec3 u = x[t[1]] - x[t[0]], v = x[t[2]] - x[t[0]], w = p - x[t[0]];
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double whole = uu * vv - uv * uv;
  if (!(whole > 0)) return {t, {1, 0, 0}};
  const double b = (vv * uw - uv * vw) / whole, c = (uu * vw - uv * uw) / whole;
  return {t, {1 - b - c, b, c}};
}

}  // namespace seamwise
