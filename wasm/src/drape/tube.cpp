#include "drape/tube.h"

#include <algorithm>
#include <cmath>

namespace seamwise {

double smoothLeast(double a, double b, double radius, double* weight_b) {
  const double apart = a - b;
  *weight_b = std::clamp(0.5 + 0.5 * apart / radius, 0.0, 1.0);
  if (std::abs(apart) >= radius) return std::min(a, b);
  return (a + b) / 2 - (apart * apart / radius + radius) / 4;
}

Tube::Cubics Tube::at(double level) const {
  Cubics all;
  // A tube keeps its size beyond its first and last section.
  if (level <= levels_.front() || level >= levels_.back()) {
    const std::size_t end = level <= levels_.front() ? 0 : levels_.size() - 1;
    for (int shape = 0; shape < kShapes; ++shape) all[shape] = {values_[shape][end], 0, 0};
    return all;
  }
  std::size_t i = 0;
  while (level > levels_[i + 1]) ++i;
  const double h = levels_[i + 1] - levels_[i];
  const double b = (level - levels_[i]) / h, a = 1 - b;
  for (int shape = 0; shape < kShapes; ++shape) {
    const double y0 = values_[shape][i], y1 = values_[shape][i + 1];
    const double m0 = bends_[shape][i], m1 = bends_[shape][i + 1];
    all[shape] = {a * y0 + b * y1 + ((a * a * a - a) * m0 + (b * b * b - b) * m1) * (h * h / 6),
                  (y1 - y0) / h + ((3 * b * b - 1) * m1 - (3 * a * a - 1) * m0) * (h / 6),
                  a * m0 + b * m1};
  }
  return all;
}

double Tube::wallDistance(const Vec3& local, Vec3* gradient) const {
  const Cubics all = at(local.z());
  const auto& [w, dw, ddw] = all[kWidth];
  const auto& [d, dd, ddd] = all[kDepth];
  const auto& [m, dm, ddm] = all[kMiddle];
  const auto& [s, ds, dds] = all[kSquare];
  // q = u^2 + v^2 + s u^2 v^2 with u w = x and v d = y - m; x, y, l: across, ahead, along.
  // Subscripts mark derivatives.
  const double u = local.x() / w, v = (local.y() - m) / d, uu = u * u, vv = v * v;
  const double u_x = 1 / w, u_l = -u * dw / w;
  const double v_y = 1 / d, v_l = -(dm + v * dd) / d;
  const double q = uu + vv + s * (uu * vv) + 1e-12;  // keeps r above 0 on the axis
  const double q_u = 2 * u * (1 + s * vv), q_v = 2 * v * (1 + s * uu), q_s = uu * vv;
  const double q_x = q_u * u_x, q_y = q_v * v_y, q_l = q_u * u_l + q_v * v_l + q_s * ds;
  const double r = std::sqrt(q), half = 0.5 / r;
  const double steep = half * std::sqrt(q_x * q_x + q_y * q_y + q_l * q_l) + 1e-9;
  const double distance = (r - 1) / steep;
  if (!gradient) return distance;
  const double u_xl = -dw / (w * w), u_ll = -(2 * u_l * dw + u * ddw) / w;
  const double v_yl = -dd / (d * d), v_ll = -(2 * v_l * dd + v * ddd + ddm) / d;
  const double q_uu = 2 * (1 + s * vv), q_vv = 2 * (1 + s * uu), q_uv = 4 * s * u * v;
  const double q_us = 2 * u * vv, q_vs = 2 * v * uu;
  const double along_u = q_uu * u_l + q_uv * v_l + q_us * ds;  // derivative of q_u along the axis
  const double along_v = q_uv * u_l + q_vv * v_l + q_vs * ds;  // derivative of q_v along the axis
  const double q_xx = q_uu * u_x * u_x, q_xy = q_uv * u_x * v_y, q_yy = q_vv * v_y * v_y;
  const double q_xl = along_u * u_x + q_u * u_xl, q_yl = along_v * v_y + q_v * v_yl;
  const double q_ll = along_u * u_l + along_v * v_l + (q_us * u_l + q_vs * v_l) * ds + q_u * u_ll +
                      q_v * v_ll + q_s * dds;
  // The distance is (r - 1) / |grad r| with r = sqrt(q).
  const double g[3] = {half * q_x, half * q_y, half * q_l};
  const double turned[3] = {q_xx * g[0] + q_xy * g[1] + q_xl * g[2],
                            q_xy * g[0] + q_yy * g[1] + q_yl * g[2],
                            q_xl * g[0] + q_yl * g[1] + q_ll * g[2]};
  const double square = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
  for (int i = 0; i < 3; ++i) {
    const double bend = half * turned[i] - g[i] * square / r;
    (*gradient)[i] = (g[i] - distance * (bend / steep)) / steep;
  }
  return distance;
}

double Tube::leastDistance(const Vec3& p) const {
  const Vec3 local = axis_.local(p);
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    const double below = low_[c] - local[c], above = local[c] - high_[c];
    const double outside = below > above ? below : above;
    if (outside > 0) sum += outside * outside;
  }
  return std::sqrt(sum);
}

double Tube::distance(const Vec3& p, Vec3* gradient) const {
  // Distance to the sides at which a ridge reaches its slope. [cm]
  constexpr double kRidge = 4;
  const Vec3 local = axis_.local(p);
  Vec3 slope;
  double d = wallDistance(local, gradient ? &slope : nullptr);
  const auto cut = [&](const TubeEnd& end, double sign) {
    const double side = std::sqrt(local.x() * local.x() + kRidge * kRidge);
    const double scale = 1 / std::sqrt(1 + end.slope * end.slope);
    const double plane = (sign * (local.z() - end.level) + end.slope * (side - kRidge)) * scale;
    double weight;
    d = -smoothLeast(-d, -plane, end.rounding, &weight);
    if (gradient)
      slope =
          slope * (1 - weight) + Vec3(end.slope * (local.x() / side), 0, sign) * (scale * weight);
  };
  cut(bottom_, -1);
  cut(top_, 1);
  if (gradient) *gradient = axis_.side * slope.x() + axis_.ahead * slope.y() + axis_.up * slope.z();
  return d;
}

}  // namespace seamwise
