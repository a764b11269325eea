#include "geometry/curve.h"

#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

// Gauss-Legendre rule of 16 points on [-1, 1]: the positive abscissae and their weights.
constexpr double kGauss[8][2] = {
    {0.98940093499164993851, 0.02715245941175409641},
    {0.94457502307323260027, 0.06225352393864789363},
    {0.86563120238783175520, 0.09515851168249278569},
    {0.75540440835500299865, 0.12462897125553387689},
    {0.61787624440264377057, 0.14959598881657673597},
    {0.45801677765722736968, 0.16915651939500253587},
    {0.28160355077925891543, 0.18260341504492358378},
    {0.09501250983763744051, 0.18945061045506850217},
};
constexpr double kLengthTolerance = 1e-12;  // relative to the control polygon
constexpr int kGreatestDepth = 40;  // a cusp halves its piece this often, then is negligible
constexpr int kTurningSamples = 8;

}  // namespace

Curve::Curve() = default;
Curve::Curve(const Curve& other) = default;
Curve::Curve(Curve&& other) noexcept = default;
Curve& Curve::operator=(const Curve& other) = default;
Curve& Curve::operator=(Curve&& other) noexcept = default;
Curve::~Curve() = default;

Curve Curve::line(const Vec2& a, const Vec2& b) {
  Curve c;
  c.p_[0] = a;
  c.p_[3] = b;
  c.length_ = (b - a).norm();
  return c;
}

Curve Curve::bezier(Kind kind, const Vec2& a, const Vec2& c1, const Vec2& c2, const Vec2& b) {
  Curve c;
  c.kind_ = kind;
  c.p_[0] = a;
  c.p_[1] = c1;
  c.p_[2] = c2;
  c.p_[3] = b;
  c.setSlope();
  c.marks_.push_back({0, 0});
  c.measure(0, 1, c.gaussLength(0, 1), 0);
  c.length_ = c.marks_.back().s;
  return c;
}

Curve Curve::quadratic(const Vec2& a, const Vec2& control, const Vec2& b) {
  return bezier(Kind::kQuadratic, a, control, control, b);
}

Curve Curve::cubic(const Vec2& a, const Vec2& c1, const Vec2& c2, const Vec2& b) {
  return bezier(Kind::kCubic, a, c1, c2, b);
}

Curve Curve::arc(const Vec2& a, const Vec2& b, double radius, bool large, bool sweep) {
  const Vec2 chord = b - a;
  const double span = chord.norm();
  if (span == 0 || radius == 0) return line(a, b);
  Curve c;
  c.kind_ = Kind::kArc;
  c.p_[0] = a;
  c.p_[3] = b;
  c.radius_ = std::max(std::abs(radius), span / 2);
  const double height = std::sqrt(std::max(0.0, c.radius_ * c.radius_ - span * span / 4));
  const double side = sweep != large ? 1 : -1;  // the centre is left of the chord
  c.p_[1] = (a + b) / 2 + perp(chord) * (height / span * side);
  const double half = std::atan2(span / 2, height);  // angle in (0, pi/2], exact near both ends
  c.sweep_ = (large ? 2 * kPi - 2 * half : 2 * half) * (sweep ? 1 : -1);
  const Vec2 from = a - c.p_[1];
  c.angle0_ = directionOf(from);
  c.length_ = c.radius_ * std::abs(c.sweep_);
  return c;
}

std::pair<const Curve*, double> Curve::cubicAt(double t) const {
  const double x = t * static_cast<double>(cubics_.size());
  const std::size_t k = std::min(static_cast<std::size_t>(std::max(x, 0.0)), cubics_.size() - 1);
  return {&cubics_[k], x - static_cast<double>(k)};
}

Vec2 Curve::at(double t) const {
  if (t <= 0) return p_[0];
  if (t >= 1) return p_[3];
  if (kind_ == Kind::kPath) {
    const auto [cubic, own] = cubicAt(t);
    return cubic->at(own);
  }
  const double u = 1 - t;
  switch (kind_) {
    case Kind::kLine:
      return u * p_[0] + t * p_[3];
    case Kind::kQuadratic:
      return u * u * p_[0] + 2 * u * t * p_[1] + t * t * p_[3];
    case Kind::kCubic:
      return u * u * u * p_[0] + 3 * u * u * t * p_[1] + 3 * u * t * t * p_[2] + t * t * t * p_[3];
    default:
      break;
  }
  return p_[1] + radius_ * unit(angle0_ + t * sweep_);
}

void Curve::setSlope() {
  if (kind_ == Kind::kQuadratic) {
    slope_[0] = 2 * (p_[1] - p_[0]);
    slope_[1] = 2 * (p_[3] - p_[1]) - slope_[0];
  } else if (kind_ == Kind::kCubic) {
    const Vec2 a = p_[1] - p_[0], b = p_[2] - p_[1], c = p_[3] - p_[2];
    slope_[0] = 3 * a;
    slope_[1] = 6 * (b - a);
    slope_[2] = 3 * (a - 2 * b + c);
  }
}

Vec2 Curve::derivative(double t) const {
  if (kind_ == Kind::kLine) return p_[3] - p_[0];
  if (kind_ == Kind::kArc) return radius_ * sweep_ * perp(unit(angle0_ + t * sweep_));
  if (kind_ == Kind::kPath) {
    const auto [cubic, own] = cubicAt(t);
    return static_cast<double>(cubics_.size()) * cubic->derivative(own);
  }
  return slope_[0] + t * (slope_[1] + t * slope_[2]);
}

double Curve::gaussLength(double t0, double t1) const {
  const double middle = (t0 + t1) / 2, half = (t1 - t0) / 2;
  const auto speed = [&](double t) {
    const double x = slope_[0].x() + t * (slope_[1].x() + t * slope_[2].x());
    const double y = slope_[0].y() + t * (slope_[1].y() + t * slope_[2].y());
    return std::sqrt(x * x + y * y);
  };
  double sum = 0;
  for (const auto& [x, w] : kGauss)
    sum += w * (speed(middle - half * x) + speed(middle + half * x));
  return half * sum;
}

void Curve::measure(double t0, double t1, double length, int depth) {
  const double middle = (t0 + t1) / 2;
  const double left = gaussLength(t0, middle), right = gaussLength(middle, t1);
  const double polygon = (p_[1] - p_[0]).norm() + (p_[2] - p_[1]).norm() + (p_[3] - p_[2]).norm();
  if (depth >= kGreatestDepth || std::abs(left + right - length) <= kLengthTolerance * polygon) {
    marks_.push_back({t1, marks_.back().s + left + right});
    return;
  }
  measure(t0, middle, left, depth + 1);
  measure(middle, t1, right, depth + 1);
}

double Curve::parameterAt(double s) const {
  if (s <= 0) return 0;
  if (s >= 1) return 1;
  if (marks_.empty() || length_ == 0) return s;
  const double target = s * length_;
  const auto next = std::upper_bound(marks_.begin() + 1, marks_.end() - 1, target,
                                     [](double value, const Mark& m) { return value < m.s; });
  const Mark from = *(next - 1), to = *next;
  double low = from.t, high = to.t;
  const double span = to.s - from.s, width = to.t - from.t;
  if (span <= 0) return low;
  if (kind_ == Kind::kPath) {
    const auto k = next - marks_.begin() - 1;
    const double own = cubics_[k].parameterAt((target - from.s) / span);
    return (static_cast<double>(k) + own) / static_cast<double>(cubics_.size());
  }
  // First guess: the cubic t(s) with the true values and slopes dt/ds = 1 / speed at both marks.
  const double x = (target - from.s) / span;
  const double v0 = derivative(from.t).norm(), v1 = derivative(to.t).norm();
  double t = low + x * width;
  if (v0 > 0 && v1 > 0) {
    const double m0 = span / v0, m1 = span / v1, y = 1 - x;
    const double guess = low + width * x * x * (3 - 2 * x) + m0 * x * y * y - m1 * x * x * y;
    if (guess > low && guess < high) t = guess;
  }
  // Newton's iteration inside the bracket, with bisection where the speed vanishes.
  for (int i = 0; i < 60; ++i) {
    const double miss = from.s + gaussLength(from.t, t) - target;
    if (std::abs(miss) <= 1e-14 * length_) break;
    (miss > 0 ? high : low) = t;
    const double speed = derivative(t).norm();
    const double step = speed > 0 ? t - miss / speed : low;
    const double better = step > low && step < high ? step : (low + high) / 2;
    const double moved = std::abs(better - t);
    t = better;
    if (moved <= 1e-15 || moved * speed <= 1e-13 * length_) break;
  }
  return t;
}

Vec2 Curve::atFraction(double s) const { return at(parameterAt(s)); }

double Curve::turning(double s0, double s1) const {
  if (kind_ == Kind::kLine) return 0;
  if (kind_ == Kind::kArc) return std::abs(sweep_) * (s1 - s0);
  if (kind_ == Kind::kPath) return turningOfPath(s0 * length_, s1 * length_);
  const double t0 = parameterAt(s0), t1 = parameterAt(s1);
  double total = 0;
  Vec2 last = Vec2::Zero();
  for (int k = 0; k <= kTurningSamples; ++k) {
    const Vec2 d = derivative(t0 + (t1 - t0) * k / kTurningSamples);
    if (d.squaredNorm() == 0) continue;
    if (last.squaredNorm() > 0) total += std::abs(turnBetween(last, d));
    last = d;
  }
  return total;
}

Polyline Curve::flattened(double tolerance) const {
  if (kind_ == Kind::kPath) {
    Polyline line{start()};
    for (const Curve& cubic : cubics_) {
      const Polyline part = cubic.flattened(tolerance);
      for (std::size_t k = 1; k < part.size(); ++k) line.push_back(part[k]);
    }
    return line;
  }
  // A chord over a parameter step h leaves the curve by at most h^2 / 8 max|p''|.
  double bend = 0;
  if (kind_ == Kind::kQuadratic) bend = 2 * (p_[0] - 2 * p_[1] + p_[3]).norm();
  if (kind_ == Kind::kCubic)
    bend = 6 * std::max((p_[0] - 2 * p_[1] + p_[2]).norm(), (p_[1] - 2 * p_[2] + p_[3]).norm());
  if (kind_ == Kind::kArc) bend = radius_ * sweep_ * sweep_;
  const double wanted = std::sqrt(bend / (8 * std::max(tolerance, 1e-9)));
  const int n = static_cast<int>(std::ceil(std::clamp(wanted, 1.0, 1e5)));
  Polyline line(n + 1);
  for (int k = 0; k <= n; ++k) line[k] = at(static_cast<double>(k) / n);
  return line;
}

Curve Curve::transformed(const RigidMotion& motion) const {
  Curve c = *this;
  for (Vec2& p : c.p_) p = motion(p);
  for (Curve& cubic : c.cubics_) cubic = cubic.transformed(motion);
  c.setSlope();
  if (kind_ == Kind::kArc) {
    const Vec2 from = c.p_[0] - c.p_[1];
    c.angle0_ = directionOf(from);
    if (motion.mirrored) c.sweep_ = -sweep_;
  }
  return c;
}

Curve Curve::reversed() const {
  Curve c = *this;
  std::swap(c.p_[0], c.p_[3]);
  if (kind_ == Kind::kArc) {
    const Vec2 from = c.p_[0] - c.p_[1];
    c.angle0_ = directionOf(from);
    c.sweep_ = -sweep_;
  } else {
    std::swap(c.p_[1], c.p_[2]);
    c.setSlope();
  }
  std::reverse(c.marks_.begin(), c.marks_.end());
  for (Mark& m : c.marks_) m = {1 - m.t, length_ - m.s};
  const std::size_t n = cubics_.size();
  for (std::size_t k = 0; k < n; ++k) c.cubics_[k] = cubics_[n - 1 - k].reversed();
  return c;
}

std::vector<Vec2> Curve::points() const {
  std::vector<Vec2> points{start()};
  if (kind_ == Kind::kPath) {
    for (const Curve& c : cubics_)
      for (const int k : {1, 2, 3}) points.push_back(c.p_[k]);
    return points;
  }
  if (kind_ == Kind::kQuadratic || kind_ == Kind::kCubic) points.push_back(p_[1]);
  if (kind_ == Kind::kCubic) points.push_back(p_[2]);
  points.push_back(end());
  return points;
}

}  // namespace seamwise
