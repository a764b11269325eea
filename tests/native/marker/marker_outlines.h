#pragma once
// Outlines of pieces, and overlap tests that are independent of the program's.
#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "geometry/vec2.h"
#include "marker/marker_problem.h"
#include "support/print_samples.h"

namespace seamwise::testing {

inline Polyline box(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

/// A polygon whose corners surround the origin at distances between `near` and `far`.
inline Polyline star(Random& random, int corners, double near, double far) {
  Polyline ring;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * kPi * (k + random.between(0.1, 0.9)) / corners;
    ring.emplace_back(random.between(near, far) * unit(angle));
  }
  return ring;
}

/// A bar with teeth on its upper side, of random widths, heights and slants.
inline Polyline comb(Random& random, int teeth) {
  Polyline upper;
  double x = 0;
  for (int k = 0; k < teeth; ++k) {
    const double wide = random.between(0.6, 2), high = random.between(3, 8);
    const double lean = random.between(-0.3, 0.3);
    upper.emplace_back(x, 1.5);
    upper.emplace_back(x + lean, high);
    upper.emplace_back(x + wide + lean, high + random.between(-1, 1));
    upper.emplace_back(x + wide, 1.5);
    x += wide + random.between(0.7, 2);
  }
  Polyline ring{{0, 0}, {upper.back().x(), 0}};
  ring.insert(ring.end(), upper.rbegin(), upper.rend());
  return ring;
}

/// A long triangle with such an oblique cut at its end that its extended sides meet far from there.
inline Polyline needle(double angle, double slant) {
  // distance from the cut's line to where the sides meet: 0.038 cm
  const double cut = 0.038 * std::sin(angle) / (std::sin(slant) * std::sin(angle + slant));
  const Vec2 end = Vec2(20, 0) + cut * unit(slant);
  const Vec2 back = end + end.x() / std::cos(angle) * unit(kPi - angle);
  return {{0, 0}, {20, 0}, end, back, {0, back.y() / 2}};
}

inline Polyline shifted(Polyline ring, const Vec2& by) {
  for (Vec2& p : ring) p += by;
  return ring;
}

/// Returns whether the point is inside, by the outline's winding number over all corners.
inline bool isInside(const Polyline& ring, const Vec2& p) {
  double turned = 0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    turned += turnBetween(ring[k] - p, ring[(k + 1) % ring.size()] - p);
  return turned > kPi;
}

inline double distanceTo(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  return (a + std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along - p).norm();
}

inline double distanceTo(const Polyline& ring, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < ring.size(); ++k)
    least = std::min(least, distanceTo(ring[k], ring[(k + 1) % ring.size()], p));
  return least;
}

inline bool doCross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return triangleArea(p, q, r) > 0;
  };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

/// Distance between two polygons; -1 where they overlap. [cm]
inline double separation(const Polyline& p, const Polyline& q) {
  if (isInside(p, q[0]) || isInside(q, p[0])) return -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Vec2 &c = q[j], &d = q[(j + 1) % q.size()];
      if (doCross(a, b, c, d)) return -1;
      least = std::min({least, distanceTo(a, b, c), distanceTo(a, b, d), distanceTo(c, d, a),
                        distanceTo(c, d, b)});
    }
  }
  return least;
}

/// Returns whether two polygons are at least `gap` apart after one has moved by at most `slack`.
/// [cm]
inline bool areApart(const Polyline& p, const Polyline& q, double gap, double slack) {
  if (separation(p, q) >= gap) return true;
  for (int k = 0; k < 16; ++k)
    if (separation(p, shifted(q, slack * unit(k * kPi / 8))) >= gap) return true;
  return false;
}

inline std::pair<Vec2, Vec2> boundsOf(const Polyline& ring) {
  Vec2 low = ring[0], high = ring[0];
  for (const Vec2& p : ring) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {low, high};
}

inline Polyline moved(const Polyline& ring, const RigidMotion& motion) {
  Polyline out;
  for (const Vec2& p : ring) out.push_back(motion(p));
  return out;
}

inline WallpaperGroup groupOf(const char* name, const Vec2& w1, const Vec2& w2) {
  auto group = WallpaperGroup::make(name, w1, w2);
  EXPECT_TRUE(group.ok()) << group.error().message;
  return std::move(group).value();
}

inline MarkerPiece pieceOf(std::string name, Polyline outline, const RigidMotion& alignment = {}) {
  MarkerPiece piece;
  piece.name = std::move(name);
  piece.outline = std::move(outline);
  piece.alignment = alignment;
  return piece;
}

}  // namespace seamwise::testing
