#include "problem/pleat_fit.h"

#include <algorithm>

namespace seamwise {
namespace {

constexpr double kOnLineCm = 1e-3;  ///< an edge may pass the line of a pleat by this much
constexpr double kTraceCm = 1e-3;   ///< accuracy of a curve's extent

}  // namespace

double PleatFit::shiftAt(double position) const {
  double shift = 0;
  for (const Strip& strip : strips)
    shift += strip.growth *
             (std::clamp((position - strip.from) / (strip.to - strip.from), 0.0, 1.0) - 0.5);
  return shift;
}

Vec2 PleatFit::drafted(const Vec2& fitted) const {
  const double position = across.dot(fitted);
  double before = shiftAt(-HUGE_VAL), shift = before;
  for (const Strip& strip : strips) {
    const double share = (position - strip.from - before) / (strip.to - strip.from + strip.growth);
    shift += strip.growth * std::clamp(share, 0.0, 1.0);
    before += strip.growth;
  }
  return fitted - shift * across;
}

double PleatFit::movement() const {
  double shift = shiftAt(-HUGE_VAL), most = std::abs(shift);
  for (const Strip& strip : strips) most = std::max(most, std::abs(shift += strip.growth));
  return most;
}

int PleatFit::stripOf(const Curve& curve) const {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec2& p : curve.flattened(kTraceCm)) {
    low = std::min(low, across.dot(p) + kOnLineCm);
    high = std::max(high, across.dot(p) - kOnLineCm);
  }
  if (low >= high) return -1;  // along the lines of the pleats
  for (std::size_t k = 0; k < strips.size(); ++k) {
    if (low >= strips[k].to || high <= strips[k].from) continue;
    const bool is_inside = low >= strips[k].from && high <= strips[k].to && !curve.circular();
    return is_inside ? static_cast<int>(k) : -2;
  }
  return -1;
}

Curve PleatFit::fitted(const Curve& curve) const {
  const int k = stripOf(curve);
  const double rigid = shiftAt(across.dot(curve.at(0.5)));
  if (curve.circular()) return curve.transformed({0.0, rigid * across, false});
  // A control point may be beyond the lines, so the map of the curve's own part continues there.
  std::vector<Vec2> points = curve.points();
  const std::size_t last = points.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    Vec2& p = points[i];
    double shift = rigid;
    if (i == 0 || i == last) {
      shift = shiftAt(across.dot(p));
    } else if (k >= 0) {
      const Strip& strip = strips[static_cast<std::size_t>(k)];
      shift = shiftAt(strip.from) +
              strip.growth * (across.dot(p) - strip.from) / (strip.to - strip.from);
    }
    p += shift * across;
  }
  if (last == 1) return Curve::line(points[0], points[1]);
  if (last == 2) return Curve::quadratic(points[0], points[1], points[2]);
  return Curve::path(points);
}

}  // namespace seamwise
