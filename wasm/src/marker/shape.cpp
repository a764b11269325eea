#include "marker/shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "geometry/polygon.h"
#include "geometry/predicates.h"
#include "marker/convex_parts.h"

namespace seamwise {
namespace {

/// Greatest growth of outlines. Differences this close to touching are checked exactly on boards of
/// few dots and cost length on boards of many. Half of it doubles the number of convex parts.
constexpr double kGrowth = 0.02;  // cm
/// The same where outlines curve inwards, because every corner there adds a convex part.
constexpr double kInwardGrowth = 0.05;  // cm

struct Corner {
  Vec2 at;
  double off = 0;  ///< bound on the distance from the given polygon along the next edge
};

double heightAbove(const Vec2& from, const Vec2& to, const Vec2& p) {
  const Vec2 along = to - from;
  return std::abs(cross(along, p - from)) / std::max(along.norm(), 1e-12);
}

/// True if two non-adjacent edges meet. (`findCrossing` is for outlines of any length and needs
/// more space in a module than all of this file.)
bool meetsItself(const Polyline& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % n];
    for (std::size_t j = i + 2; j < n && j + 1 < n + i; ++j) {
      const Vec2 &c = ring[j], &d = ring[(j + 1) % n];
      const bool are_boxes_apart = (a.cwiseMax(b).array() < c.cwiseMin(d).array()).any() ||
                                   (c.cwiseMax(d).array() < a.cwiseMin(b).array()).any();
      if (!are_boxes_apart && orientation(a, b, c) * orientation(a, b, d) <= 0 &&
          orientation(c, d, a) * orientation(c, d, b) <= 0)
        return true;
    }
  }
  return false;
}

}  // namespace

Vec2 rounded(const Vec2& p) {
  constexpr double kSteps = 1 << 20;
  return {std::nearbyint(p.x() * kSteps) / kSteps, std::nearbyint(p.y() * kSteps) / kSteps};
}

Polyline simplifiedOutwards(const Polyline& polygon, double most, double most_inwards) {
  std::vector<Corner> left;
  for (const Vec2& p : polygon) left.push_back({p});
  bool again = true;
  while (again && left.size() > 4) {
    again = false;
    for (std::size_t k = 0; k < left.size() && left.size() > 4;) {
      const std::size_t n = left.size();
      const std::size_t before = (k + n - 1) % n, after = (k + 1) % n, next = (k + 2) % n;
      const Vec2 &a = left[before].at, &b = left[k].at, &c = left[after].at, &d = left[next].at;
      if (cross(b - a, c - b) <= 0) {  // points inwards, or is on the line
        const double off = heightAbove(a, c, b) + std::max(left[before].off, left[k].off);
        if (off <= most_inwards) {
          left[before].off = off;
          left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
          again = true;
          continue;
        }
      } else if (const Vec2 u = b - a, v = d - c; cross(c - b, v) > 0 && cross(u, v) > 1e-9) {
        const Vec2 tip = b + u * (cross(c - b, v) / cross(u, v));
        const double off = nearestOnPolyline({b, c}, tip).distance +
                           std::max({left[before].off, left[k].off, left[after].off});
        if (off <= most) {
          left[before].off = left[k].off = off;
          left[k] = {tip, off};
          left.erase(left.begin() + static_cast<std::ptrdiff_t>(after));
          again = true;
          continue;
        }
      }
      ++k;
    }
  }
  Polyline simple;
  for (const Corner& corner : left) simple.push_back(corner.at);
  return meetsItself(simple) ? polygon : simple;
}

Shape shapeOf(const Polyline& outline, const Mat2& turn) {
  Shape shape;
  for (const Vec2& p : outline) {
    const Vec2 q = rounded(turn * p);
    if (shape.ring.empty() || q != shape.ring.back()) shape.ring.push_back(q);
  }
  while (shape.ring.size() > 1 && shape.ring.front() == shape.ring.back()) shape.ring.pop_back();
  shape.low = shape.high = shape.ring.front();
  for (const Vec2& p : shape.ring) {
    shape.low = shape.low.cwiseMin(p);
    shape.high = shape.high.cwiseMax(p);
  }
  shape.area = signedArea(shape.ring);
  if (shape.area < 0) {  // flaws may have either orientation
    std::reverse(shape.ring.begin(), shape.ring.end());
    shape.area = -shape.area;
  }
  shape.parts = convexParts(simplifiedOutwards(shape.ring, kGrowth, kInwardGrowth), 2 * kTouching);
  double largest = 0;
  for (const Polyline& part : shape.parts) {
    if (signedArea(part) <= largest) continue;
    largest = signedArea(part);
    shape.inner = std::accumulate(part.begin(), part.end(), Vec2(0, 0)) / part.size();
  }
  return shape;
}

}  // namespace seamwise
