#include "pattern/loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seamwise {
namespace {

constexpr int kCurveSteps = 16;
constexpr double kAtCorner = 1e-9;  // cm

}  // namespace

Loop::Loop(const std::vector<Curve>* edges) : edges_(edges), corner_{0} {
  for (const Curve& c : *edges) {
    const int steps = c.straight() ? 1 : c.stepsAlong(kCurveSteps);
    corners_.push_back(corner_.back());
    for (const double s : c.corners()) corners_.push_back(corner_.back() + s * c.length());
    for (int k = 0; k < steps; ++k) {
      const double s = static_cast<double>(k) / steps;
      samples_.push_back({corner_.back() + s * c.length(), c.atFraction(s)});
    }
    corner_.push_back(corner_.back() + c.length());
  }
  samples_.push_back({length(), samples_.front().point});
}

/// Wraps a position outside [0, length()). Only positions further than one turn away need a
/// division.
double Loop::turned(double position) const {
  const double turn = length();
  double p = position;
  if (position >= turn && position < 2 * turn)
    p -= turn;
  else if (!(std::abs(position) < turn))
    p = std::fmod(position, turn);
  if (p < 0) p += turn;
  return p < turn ? p : 0;
}

int Loop::edgeAt(double position) const {
  const auto next = std::upper_bound(corner_.begin() + 1, corner_.end() - 1, wrapped(position));
  return static_cast<int>(next - corner_.begin()) - 1;
}

bool Loop::isCorner(double position) const {
  const double p = wrapped(position);
  return p - *(std::upper_bound(corners_.begin() + 1, corners_.end(), p) - 1) <= kAtCorner;
}

Vec2 Loop::at(double position) const {
  const double p = wrapped(position);
  const int k = edgeAt(p);
  const double length = edge(k).length();
  return edge(k).atFraction(length > 0 ? (p - corner_[k]) / length : 0);
}

double Loop::nearest(const Vec2& p, double from, double to) const {
  double best = from, least = std::numeric_limits<double>::infinity();
  double low = from, high = from;  // interval that may contain a better position, on a curve
  const auto consider = [&](double position, const Vec2& q, double a, double b) {
    const double distance = (q - p).squaredNorm();
    if (distance >= least) return;
    least = distance;
    best = position;
    low = std::max(from, a);
    high = std::min(to, b);
  };
  consider(from, at(from), from, from);
  consider(to, at(to), to, to);
  const double turn = length();
  for (double offset = std::floor(from / turn) * turn; offset < to; offset += turn) {
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
      const double a = samples_[i].position + offset, b = samples_[i + 1].position + offset;
      if (b < from || a > to || b <= a) continue;
      const Vec2 d = samples_[i + 1].point - samples_[i].point;
      const double square = d.squaredNorm();
      const double along = square > 0 ? (p - samples_[i].point).dot(d) / square : 0;
      const double x =
          std::clamp(along, (std::max(a, from) - a) / (b - a), (std::min(b, to) - a) / (b - a));
      // The nearest point of a curve may be one chord further.
      const bool straight = edge(edgeAt((a + b) / 2)).straight();
      consider(a + x * (b - a), samples_[i].point + x * d, straight ? a : 2 * a - b,
               straight ? a : 2 * b - a);
    }
  }
  // Minimize the squared distance by golden-section search.
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  const auto cost = [&](double position) { return (at(position) - p).squaredNorm(); };
  double x1 = high - ratio * (high - low), x2 = low + ratio * (high - low);
  double f1 = cost(x1), f2 = cost(x2);
  while (high - low > 1e-8) {
    if (f1 < f2) {
      high = x2, x2 = x1, f2 = f1;
      x1 = high - ratio * (high - low);
      f1 = cost(x1);
    } else {
      low = x1, x1 = x2, f1 = f2;
      x2 = low + ratio * (high - low);
      f2 = cost(x2);
    }
  }
  const double refined = (low + high) / 2;
  return cost(refined) < cost(best) ? refined : best;
}

Vec2 Loop::middle() const {
  Vec2 low = samples_.front().point, high = low;
  for (const Sample& s : samples_) {
    low = low.cwiseMin(s.point);
    high = high.cwiseMax(s.point);
  }
  return (low + high) / 2;
}

}  // namespace seamwise
