#include "marker/convex_parts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

#include "geometry/predicates.h"

namespace seamwise {
namespace {

using Indices = std::vector<int>;

bool isInTriangle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
}

bool isEar(const Polyline& ring, const Indices& left, std::size_t k) {
  const std::size_t n = left.size();
  const int before = left[(k + n - 1) % n], at = left[k], after = left[(k + 1) % n];
  const Vec2 &a = ring[before], &b = ring[at], &c = ring[after];
  if (orientation(a, b, c) <= 0) return false;
  return std::none_of(left.begin(), left.end(), [&](int v) {
    const Vec2& p = ring[v];
    return v != before && v != at && v != after && p != a && p != b && p != c &&
           isInTriangle(a, b, c, p);
  });
}

std::vector<Indices> triangles(const Polyline& ring) {
  Indices left(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) left[k] = static_cast<int>(k);
  std::vector<Indices> found;
  std::size_t k = 0, idle = 0;
  while (left.size() > 3 && idle < left.size()) {
    const std::size_t n = left.size();
    const int before = left[(k + n - 1) % n], at = left[k % n], after = left[(k + 1) % n];
    const bool is_flat = orientation(ring[before], ring[at], ring[after]) == 0;
    if (is_flat || isEar(ring, left, k % n)) {
      if (!is_flat) found.push_back({before, at, after});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(k % n));
      idle = 0;
    } else {
      ++k;
      ++idle;
    }
    k %= left.size();
  }
  if (left.size() == 3 && orientation(ring[left[0]], ring[left[1]], ring[left[2]]) > 0)
    found.push_back(left);
  return found;
}

/// Joins two parts: the rest of `b` after its edge to -> from replaces the edge from -> to of `a`.
Indices joined(const Indices& a, const Indices& b, int from, int to) {
  const auto of_a = std::find(a.begin(), a.end(), to);
  const auto of_b = std::find(b.begin(), b.end(), from);
  const auto first = static_cast<std::size_t>(of_a - a.begin());
  const auto second = static_cast<std::size_t>(of_b - b.begin());
  Indices all;
  for (std::size_t k = 0; k < a.size(); ++k) all.push_back(a[(first + k) % a.size()]);
  for (std::size_t k = 1; k + 1 < b.size(); ++k) all.push_back(b[(second + k) % b.size()]);
  return all;  // vertices to ... from ... to
}

bool isConvex(const Polyline& ring, const Indices& part) {
  const std::size_t n = part.size();
  for (std::size_t k = 0; k < n; ++k)
    if (orientation(ring[part[k]], ring[part[(k + 1) % n]], ring[part[(k + 2) % n]]) < 0)
      return false;
  return true;
}

bool hasEdge(const Indices& part, int from, int to) {
  for (std::size_t k = 0; k < part.size(); ++k)
    if (part[k] == from && part[(k + 1) % part.size()] == to) return true;
  return false;
}

std::vector<Indices> merged(const Polyline& ring, std::vector<Indices> parts) {
  for (std::size_t a = 0; a < parts.size(); ++a) {
    bool again = true;
    while (again) {
      again = false;
      for (std::size_t k = 0; k < parts[a].size() && !again; ++k) {
        const int from = parts[a][k], to = parts[a][(k + 1) % parts[a].size()];
        for (std::size_t b = a + 1; b < parts.size() && !again; ++b) {
          if (!hasEdge(parts[b], to, from)) continue;
          const Indices both = joined(parts[a], parts[b], from, to);
          if (!isConvex(ring, both)) continue;
          parts[a] = both;
          parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(b));
          again = true;
        }
      }
    }
  }
  return parts;
}

/// Intersection of the lines p + s u and q + t v; q if there is none.
Vec2 meeting(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v) {
  const double across = cross(u, v);
  return std::abs(across) < 1e-9 ? q : Vec2(p + u * (cross(q - p, v) / across));
}

Polyline grown(const Polyline& ring, const Indices& part, double overlap) {
  const std::size_t n = part.size(), m = ring.size();
  struct Line {
    Vec2 at, along;
  };
  std::vector<Line> lines;
  for (std::size_t k = 0; k < n; ++k) {
    const int from = part[k], to = part[(k + 1) % n];
    const Vec2 along = (ring[to] - ring[from]).normalized();
    const bool is_own = (static_cast<std::size_t>(from) + 1) % m == static_cast<std::size_t>(to);
    lines.push_back({is_own ? ring[from] : Vec2(ring[from] - overlap * perp(along)), along});
  }
  Polyline out;
  for (std::size_t k = 0; k < n; ++k) {
    const Line &before = lines[(k + n - 1) % n], &after = lines[k];
    const Vec2& corner = ring[part[k]];
    const Vec2 at = meeting(before.at, before.along, after.at, after.along);
    // The lines at nearly straight corners and slivers meet too far away.
    out.push_back((at - corner).norm() > 4 * overlap ? corner : at);
  }
  return out;
}

/// Rotates the vertices to start at the lowest one, at the leftmost of several.
Polyline fromLowest(const Polyline& convex) {
  const auto lowest = std::min_element(
      convex.begin(), convex.end(),
      [](const Vec2& a, const Vec2& b) { return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x(); });
  Polyline ring(lowest, convex.end());
  for (auto vertex = convex.begin(); vertex != lowest; ++vertex) ring.push_back(*vertex);
  return ring;
}

}  // namespace

std::vector<Polyline> convexParts(const Polyline& polygon, double overlap) {
  std::vector<Polyline> parts;
  for (const Indices& part : merged(polygon, triangles(polygon)))
    parts.push_back(grown(polygon, part, overlap));
  return parts;
}

Polyline convexDifference(const Polyline& a, const Polyline& b) {
  Polyline turned;
  for (const Vec2& p : b) {
    const Vec2 opposite = -p;
    turned.push_back(opposite);
  }
  const Polyline p = fromLowest(a), q = fromLowest(turned);
  const std::size_t n = p.size(), m = q.size();
  Polyline sum;
  for (std::size_t i = 0, j = 0; i < n || j < m;) {
    const Vec2 corner = p[i % n] + q[j % m];
    sum.push_back(corner);
    const Vec2 u = p[(i + 1) % n] - p[i % n], v = q[(j + 1) % m] - q[j % m];
    const double turn = i == n ? -1 : j == m ? 1 : cross(u, v);
    if (turn >= 0) ++i;
    if (turn <= 0) ++j;
  }
  return sum;
}

}  // namespace seamwise
