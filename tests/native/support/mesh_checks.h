#pragma once
// Pieces to mesh, and the properties of every mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/polygon.h"
#include "mesh/mesh.h"

namespace seamwise::testing {

using Triangle = std::array<int, 3>;

/// A piece whose rest positions are those of its loops only; holes are clockwise.
inline Piece pieceOf(const Polyline& outline, const std::vector<Polyline>& holes = {}) {
  Piece piece;
  piece.name = "piece";
  const auto add = [&](const Polyline& loop) {
    std::vector<int> ring;
    for (const Vec2& p : loop) {
      ring.push_back(static_cast<int>(piece.rest.size()));
      piece.rest.push_back(p);
    }
    return ring;
  };
  piece.outline = add(outline);
  for (const Polyline& hole : holes) piece.holes.push_back(add(hole));
  return piece;
}

/// Straight edges cut into equal parts of at most `step`.
inline Polyline sampled(const Polyline& corners, double step) {
  Polyline line;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const int n = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step - 1e-9)));
    for (int k = 0; k < n; ++k) line.push_back(a + (b - a) * k / n);
  }
  return line;
}

inline Polyline circle(const Vec2& centre, double radius, int n, bool clockwise = false) {
  Polyline line;
  for (int k = 0; k < n; ++k)
    line.push_back(centre + radius * unit((clockwise ? -1 : 1) * 2 * kPi * k / n));
  return line;
}

inline double area(const Piece& p, const Triangle& t) {
  return cross(p.rest[t[1]] - p.rest[t[0]], p.rest[t[2]] - p.rest[t[0]]) / 2;
}

inline double smallestAngle(const Piece& p, const Triangle& t) {
  double least = kPi;
  for (int k = 0; k < 3; ++k) {
    const Vec2 u = p.rest[t[(k + 1) % 3]] - p.rest[t[k]], v = p.rest[t[(k + 2) % 3]] - p.rest[t[k]];
    least = std::min(least, std::atan2(cross(u, v), u.dot(v)));
  }
  return least;
}

/// Expects counter-clockwise triangles that fill the outline, use every vertex, and have it as
/// their border.
inline void expectFilled(const Piece& p) {
  double sum = 0, wanted = 0;
  std::set<std::pair<int, int>> sides, rim;
  std::set<int> used;
  for (const Triangle& t : p.triangles) {
    EXPECT_GT(area(p, t), 0);
    sum += area(p, t);
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second);
      used.insert(t[k]);
    }
  }
  std::vector<std::vector<int>> loops = p.holes;
  loops.push_back(p.outline);
  for (const auto& loop : loops) {
    Polyline line;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      line.push_back(p.rest[loop[i]]);
      rim.insert({loop[i], loop[(i + 1) % loop.size()]});
    }
    wanted += signedArea(line);
  }
  EXPECT_NEAR(sum, wanted, 1e-7 * (1 + wanted));
  EXPECT_EQ(used.size(), p.rest.size());
  std::set<std::pair<int, int>> border;
  for (const auto& [a, b] : sides)
    if (!sides.count({b, a})) border.insert({a, b});
  EXPECT_EQ(border, rim);
}

inline Piece filled(const Piece& piece, double coarsest = 2) {
  Pattern pattern;
  pattern.pieces = {piece};
  const auto outcome = meshed(pattern, coarsest);
  EXPECT_TRUE(outcome.ok()) << (outcome.ok() ? "" : outcome.error().message);
  if (!outcome.ok()) return piece;
  expectFilled(outcome.value().pieces[0]);
  return outcome.value().pieces[0];
}

}  // namespace seamwise::testing
