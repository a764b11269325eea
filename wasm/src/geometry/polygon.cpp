#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/predicates.h"

namespace seamwise {
namespace {

struct Segment {
  Vec2 a, b;
  int loop, edge;
};

bool boxesMeet(const Segment& s, const Segment& t) {
  return std::max(s.a.x(), s.b.x()) >= std::min(t.a.x(), t.b.x()) &&
         std::max(t.a.x(), t.b.x()) >= std::min(s.a.x(), s.b.x()) &&
         std::max(s.a.y(), s.b.y()) >= std::min(t.a.y(), t.b.y()) &&
         std::max(t.a.y(), t.b.y()) >= std::min(s.a.y(), s.b.y());
}

bool inBox(const Segment& s, const Vec2& p) {
  return p.x() >= std::min(s.a.x(), s.b.x()) && p.x() <= std::max(s.a.x(), s.b.x()) &&
         p.y() >= std::min(s.a.y(), s.b.y()) && p.y() <= std::max(s.a.y(), s.b.y());
}

/// The point where two closed segments meet; touching counts.
std::optional<Vec2> meet(const Segment& s, const Segment& t) {
  if (!boxesMeet(s, t)) return {};
  const int a = orientation(s.a, s.b, t.a), b = orientation(s.a, s.b, t.b);
  const int c = orientation(t.a, t.b, s.a), d = orientation(t.a, t.b, s.b);
  if (a * b < 0 && c * d < 0) {
    const Vec2 u = s.b - s.a, v = t.b - t.a;
    const double x = std::clamp(cross(t.a - s.a, v) / cross(u, v), 0.0, 1.0);
    return s.a + x * u;
  }
  if (a == 0 && inBox(s, t.a)) return t.a;
  if (b == 0 && inBox(s, t.b)) return t.b;
  if (c == 0 && inBox(t, s.a)) return s.a;
  if (d == 0 && inBox(t, s.b)) return s.b;
  return {};
}

/// The point where edges meet but should not. s and t may share a vertex when t follows s in their
/// loop.
std::optional<Vec2> collide(const Segment& s, const Segment& t, int loop_size) {
  if (s.loop != t.loop || loop_size < 3) return meet(s, t);
  const bool follows = (s.edge + 1) % loop_size == t.edge;
  const bool leads = (t.edge + 1) % loop_size == s.edge;
  if (!follows && !leads) return meet(s, t);
  const Segment &first = follows ? s : t, &second = follows ? t : s;
  // They share first.b = second.a; folding back means collinear with opposite directions.
  const Vec2 u = first.b - first.a, v = second.b - second.a;
  const bool folds = orientation(first.a, first.b, second.b) == 0 && u.dot(v) <= 0;
  if (folds) return first.b;
  return {};
}

}  // namespace

double signedArea(const Polyline& closed) {
  if (closed.empty()) return 0;
  double twice = 0;
  const Vec2& o = closed.front();  // nearby origin: less cancellation
  for (std::size_t i = 0; i < closed.size(); ++i)
    twice += cross(closed[i] - o, closed[(i + 1) % closed.size()] - o);
  return twice / 2;
}

std::optional<Crossing> findCrossing(const std::vector<Polyline>& loops) {
  std::vector<Segment> segments;
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::max()), high = -low;
  double total = 0;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const int n = static_cast<int>(loops[l].size());
    for (int k = 0; k < n; ++k) {
      segments.push_back({loops[l][k], loops[l][(k + 1) % n], static_cast<int>(l), k});
      low = low.cwiseMin(loops[l][k]);
      high = high.cwiseMax(loops[l][k]);
      total += (segments.back().b - segments.back().a).norm();
    }
  }
  if (segments.empty()) return {};
  // Cells are about as large as an edge, with at most a few cells per edge.
  const double count = static_cast<double>(segments.size());
  const Vec2 extent = (high - low).cwiseMax(1e-12);
  const double cell = std::max({total / count, std::sqrt(extent.x() * extent.y() / (4 * count)),
                                extent.maxCoeff() / (4 * count)});
  const int columns = 1 + static_cast<int>(extent.x() / cell);
  const int rows = 1 + static_cast<int>(extent.y() / cell);
  // A cell's segments in ascending order, as a linked list.
  struct Entry {
    int segment, next;
  };
  struct Bucket {
    int first = -1, last = -1;
  };
  std::vector<Entry> entries;
  entries.reserve(3 * segments.size());
  std::vector<Bucket> grid(static_cast<std::size_t>(columns) * rows);
  const auto cellOf = [&](double value, double from, int limit) {
    return std::clamp(static_cast<int>((value - from) / cell), 0, limit - 1);
  };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    const int x0 = cellOf(std::min(s.a.x(), s.b.x()), low.x(), columns);
    const int x1 = cellOf(std::max(s.a.x(), s.b.x()), low.x(), columns);
    const int y0 = cellOf(std::min(s.a.y(), s.b.y()), low.y(), rows);
    const int y1 = cellOf(std::max(s.a.y(), s.b.y()), low.y(), rows);
    const Vec2 d = s.b - s.a;
    const double reach = cell * (std::abs(d.x()) + std::abs(d.y())) * 0.500001;
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        // Skip cells of the edge's box that the line of a long slanting edge misses.
        const Vec2 centre = low + cell * Vec2(x + 0.5, y + 0.5);
        if (x1 > x0 && y1 > y0 && std::abs(cross(d, centre - s.a)) > reach) continue;
        auto& bucket = grid[static_cast<std::size_t>(y) * columns + x];
        for (int k = bucket.first; k >= 0; k = entries[k].next) {
          const Segment& t = segments[entries[k].segment];
          const auto at = collide(t, s, static_cast<int>(loops[s.loop].size()));
          if (at) return Crossing{t.loop, t.edge, s.loop, s.edge, *at};
        }
        (bucket.first < 0 ? bucket.first : entries[bucket.last].next) =
            static_cast<int>(entries.size());
        bucket.last = static_cast<int>(entries.size());
        entries.push_back({static_cast<int>(i), -1});
      }
    }
  }
  return {};
}

std::optional<Crossing> findCrossing(const Polyline& closed) {
  return findCrossing(std::vector<Polyline>{closed});
}

bool contains(const Polyline& closed, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = closed.size() - 1; i < closed.size(); j = i++) {
    const Vec2 &a = closed[j], &b = closed[i];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > p.x()) inside = !inside;
  }
  return inside;
}

Nearest nearestOnPolyline(const Polyline& line, const Vec2& p) {
  Nearest best;
  best.distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 d = line[k + 1] - line[k];
    const double square = d.squaredNorm();
    const double along = square > 0 ? std::clamp((p - line[k]).dot(d) / square, 0.0, 1.0) : 0.0;
    const Vec2 q = line[k] + along * d;
    const double distance = (p - q).norm();
    if (distance < best.distance) best = {static_cast<int>(k), along, q, distance};
  }
  return best;
}

}  // namespace seamwise
