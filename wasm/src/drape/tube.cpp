#include "drape/tube.h"

#include <algorithm>
#include <cmath>

#include "drape/turn.h"

namespace seamwise {
namespace {

constexpr int kCorners = 96;

// Second derivatives of the natural cubic spline through the values: tridiagonal elimination.
std::vector<double> splineBends(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> bend(n, 0.0), upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
    const double jump = (y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before;
    const double pivot = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    bend[i] = (6 * jump - before * bend[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) bend[i] -= upper[i] * bend[i + 1];
  return bend;
}

}  // namespace

std::vector<Vec2> Section::polygon() const {
  std::vector<Vec2> corners;
  for (int k = 0; k < kCorners; ++k) {
    const Turn turn = turnOfDegrees(k * (360.0 / kCorners));
    const double cc = turn.cosine * turn.cosine, ss = turn.sine * turn.sine;
    const double r = std::sqrt(2 / (1 + std::sqrt(1 + 4 * square * cc * ss)));
    corners.push_back({r * turn.sine * width, middle + r * turn.cosine * depth});
  }
  return corners;
}

double Section::girth() const {
  const std::vector<Vec2> corners = polygon();
  double sum = 0;
  for (int k = 0; k < kCorners; ++k)
    sum += planarLength(Vec2(corners[(k + 1) % kCorners] - corners[k]));
  return sum;
}

Section Section::withGirth(double girth_cm) const {
  const double scale = girth_cm / girth();
  Section scaled = *this;
  scaled.width *= scale;
  scaled.depth *= scale;
  return scaled;
}

double smoothLeast(double a, double b, double radius, double* weight_b) {
  const double apart = a - b;
  *weight_b = std::clamp(0.5 + 0.5 * apart / radius, 0.0, 1.0);
  if (std::abs(apart) >= radius) return std::min(a, b);
  return (a + b) / 2 - (apart * apart / radius + radius) / 4;
}

Tube::Tube(Axis axis, const std::vector<Section>& sections, TubeEnd bottom, TubeEnd top)
    : axis_(std::move(axis)), bottom_(bottom), top_(top) {
  for (const Section& s : sections) {
    levels_.push_back(s.level);
    values_[kWidth].push_back(s.width);
    values_[kDepth].push_back(s.depth);
    values_[kMiddle].push_back(s.middle);
    values_[kSquare].push_back(s.square);
  }
  for (int shape = 0; shape < kShapes; ++shape)
    bends_[shape] = splineBends(levels_, values_[shape]);
}

Tube::Cubic Tube::at(Shape shape, double level) const {
  // Beyond its first and last section a tube stays as wide as there.
  if (level <= levels_.front()) return {values_[shape].front(), 0, 0};
  if (level >= levels_.back()) return {values_[shape].back(), 0, 0};
  std::size_t i = 0;
  while (level > levels_[i + 1]) ++i;
  const double h = levels_[i + 1] - levels_[i];
  const double b = (level - levels_[i]) / h, a = 1 - b;
  const double y0 = values_[shape][i], y1 = values_[shape][i + 1];
  const double m0 = bends_[shape][i], m1 = bends_[shape][i + 1];
  return {a * y0 + b * y1 + ((a * a * a - a) * m0 + (b * b * b - b) * m1) * (h * h / 6),
          (y1 - y0) / h + ((3 * b * b - 1) * m1 - (3 * a * a - 1) * m0) * (h / 6), a * m0 + b * m1};
}

Section Tube::section(double level) const {
  return {level, at(kWidth, level).value, at(kDepth, level).value, at(kMiddle, level).value,
          at(kSquare, level).value};
}

double Tube::wallDistance(const Vec3& local, Vec3* gradient) const {
  const Jet level = Jet::variable(local.z(), 2);
  const auto shape = [&](Shape which) {
    const Cubic c = at(which, local.z());
    return level.chain(c.value, c.slope, c.bend);
  };
  const Jet u = Jet::variable(local.x(), 0) * inverse(shape(kWidth));
  const Jet v = (Jet::variable(local.y(), 1) - shape(kMiddle)) * inverse(shape(kDepth));
  const Jet uu = u * u, vv = v * v;
  Jet q = uu + vv + shape(kSquare) * (uu * vv);
  q.value += 1e-12;  // on the axis itself
  const Jet r = root(q);
  const auto& g = r.gradient;
  const auto& h = r.hessian;
  const double steep = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) + 1e-9;
  const double distance = (r.value - 1) / steep;
  if (gradient) {
    const double bend[3] = {h[0] * g[0] + h[1] * g[1] + h[2] * g[2],
                            h[1] * g[0] + h[3] * g[1] + h[4] * g[2],
                            h[2] * g[0] + h[4] * g[1] + h[5] * g[2]};
    for (int i = 0; i < 3; ++i) (*gradient)[i] = (g[i] - distance * (bend[i] / steep)) / steep;
  }
  return distance;
}

double Tube::distance(const Vec3& p, Vec3* gradient) const {
  // How far a ridge reaches to the sides before it has its slope. [cm]
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
