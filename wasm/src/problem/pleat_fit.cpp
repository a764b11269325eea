#include "problem/pleat_fit.h"

#include <algorithm>
#include <utility>

namespace seamwise {
namespace {

constexpr double kOnLineCm = 1e-3;  ///< an edge may pass the line of a pleat by this much
constexpr double kTraceCm = 1e-3;   ///< accuracy of a curve's extent

/// Growth of the strips up to a position.
double grown(const std::vector<PleatFit::Strip>& strips, double position) {
  double sum = 0;
  for (const PleatFit::Strip& strip : strips)
    sum += strip.growth * std::clamp((position - strip.from) / (strip.to - strip.from), 0.0, 1.0);
  return sum;
}

}  // namespace

PleatFit::PleatFit(const Vec2& across, std::vector<Strip> strips)
    : across_(across), strips_(std::move(strips)) {
  double total = 0;
  for (const Strip& strip : strips_) total += strip.growth;
  start_ = -total / 2;
  double before = start_;
  for (const Strip& strip : strips_) {
    const double after = before + strip.growth;
    fitted_strips_.push_back({strip.from + before, strip.to + after, strip.growth});
    before = after;
  }
}

double PleatFit::shiftAt(double position) const { return start_ + grown(strips_, position); }

Vec2 PleatFit::fitted(const Vec2& drafted) const {
  return drafted + shiftAt(position(drafted)) * across_;
}

Vec2 PleatFit::drafted(const Vec2& fitted) const {
  return fitted - (start_ + grown(fitted_strips_, position(fitted))) * across_;
}

double PleatFit::movement() const {
  double most = std::abs(start_), shift = start_;
  for (const Strip& strip : strips_) most = std::max(most, std::abs(shift += strip.growth));
  return most;
}

std::array<double, 2> PleatFit::extent(const Curve& curve) const {
  std::array<double, 2> found{HUGE_VAL, -HUGE_VAL};
  for (const Vec2& p : curve.flattened(kTraceCm)) {
    found[0] = std::min(found[0], position(p));
    found[1] = std::max(found[1], position(p));
  }
  return found;
}

int PleatFit::stripOf(const Curve& curve) const {
  const auto [low, high] = extent(curve);
  for (std::size_t k = 0; k < strips_.size(); ++k)
    if (low >= strips_[k].from - kOnLineCm && high <= strips_[k].to + kOnLineCm &&
        high - low > 2 * kOnLineCm)
      return static_cast<int>(k);
  return -1;
}

bool PleatFit::holds(const Curve& curve) const {
  if (stripOf(curve) >= 0) return !curve.circular();
  const std::array<double, 2> ends = extent(curve);
  return std::none_of(strips_.begin(), strips_.end(), [&](const Strip& strip) {
    return ends[0] < strip.to - kOnLineCm && ends[1] > strip.from + kOnLineCm;
  });
}

Curve PleatFit::fitted(const Curve& curve) const {
  const int k = stripOf(curve);
  const auto [low, high] = extent(curve);
  const double rigid = shiftAt((low + high) / 2);
  if (curve.circular()) return curve.transformed({0.0, rigid * across_, false});
  // A control point may be beyond the lines, so the map of the curve's own part continues there.
  const auto map = [&](const Vec2& p) -> Vec2 {
    if (k < 0) return p + rigid * across_;
    const Strip& strip = strips_[static_cast<std::size_t>(k)];
    const double share = (position(p) - strip.from) / (strip.to - strip.from);
    return p + (shiftAt(strip.from) + share * strip.growth) * across_;
  };
  std::vector<Vec2> points = curve.points();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) points[i] = map(points[i]);
  points.front() = fitted(points.front());
  points.back() = fitted(points.back());
  switch (points.size()) {
    case 2:
      return Curve::line(points[0], points[1]);
    case 3:
      return Curve::quadratic(points[0], points[1], points[2]);
    case 4:
      return Curve::cubic(points[0], points[1], points[2], points[3]);
    default:
      return Curve::path(points);
  }
}

}  // namespace seamwise
