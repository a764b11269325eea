#include "marker/difference_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "geometry/polygon.h"
#include "marker/convex_parts.h"

namespace seamwise {
namespace {

constexpr double kUnit = 0.01;  ///< unit of depths. [cm]
/// Depth below which rough parts and full outlines may disagree, because both outlines grow. [cm]
constexpr double kDoubtful = 0.5;
/// Greatest overlap that counts as touching if pieces need no gap: ten times the rounding error of
/// touching lines. With a greater one, long edges would share some square millimetres. [cm]
constexpr double kCommon = 1e-5;
/// Distance of rough parts below which full outlines are checked for such overlaps. [cm]
constexpr double kHidden = 1e-3;

struct HalfPlane {
  Vec2 normal;  ///< outward, of length 1
  double at;    ///< coordinate along the normal
};

std::vector<HalfPlane> halfPlanes(const Polyline& convex) {
  std::vector<HalfPlane> sides;
  for (std::size_t k = 0; k < convex.size(); ++k) {
    const Vec2 edge = convex[(k + 1) % convex.size()] - convex[k];
    const double length = edge.norm();
    if (length < 1e-9) continue;
    const Vec2 normal = -perp(edge) / length;
    sides.push_back({normal, normal.dot(convex[k])});
  }
  return sides;
}

double segmentDistance(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  const double share =
      std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-18), 0.0, 1.0);
  return (a + share * along - p).norm();
}

double outlineDistance(const Polyline& ring, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < ring.size(); ++k)
    least = std::min(least, segmentDistance(ring[k], ring[(k + 1) % ring.size()], p));
  return least;
}

bool edgesCross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 u = b - a, v = d - c;
  return cross(u, c - a) * cross(u, d - a) < 0 && cross(v, a - c) * cross(v, b - c) < 0;
}

/// True if p is deeper inside the polygon than touching allows.
bool isDeepIn(const Polyline& ring, const Vec2& p) {
  return contains(ring, p) && outlineDistance(ring, p) > kCommon;
}

/// True if a corner or the middle of an edge of `points` + shift is deep inside the polygon.
bool reachesInto(const Polyline& ring, const Vec2& low, const Vec2& high, const Polyline& points,
                 const Vec2& shift) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 p = points[k] + shift, q = points[(k + 1) % points.size()] + shift;
    for (const Vec2& at : {p, Vec2((p + q) / 2)}) {
      const bool is_near = (at.array() > low.array()).all() && (at.array() < high.array()).all();
      if (is_near && isDeepIn(ring, at)) return true;
    }
  }
  return false;
}

/// True if two full outlines, the second shifted, keep the gap. Overlaps up to kCommon are allowed.
bool areApart(const Shape& first, const Shape& second, const Vec2& shift, double gap) {
  const double room = std::max(gap - kTouching, 0.0);
  const Polyline &p = first.ring, &q = second.ring;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    const Vec2 low = a.cwiseMin(b).array() - gap;
    const Vec2 high = a.cwiseMax(b).array() + gap;
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Vec2 c = q[j] + shift, d = q[(j + 1) % q.size()] + shift;
      if ((c.cwiseMax(d).array() < low.array()).any() ||
          (c.cwiseMin(d).array() > high.array()).any())
        continue;
      const double distance =
          std::min(std::min(segmentDistance(a, b, c), segmentDistance(a, b, d)),
                   std::min(segmentDistance(c, d, a), segmentDistance(c, d, b)));
      if (edgesCross(a, b, c, d) ? distance > kCommon || room > 0 : distance < room) return false;
    }
  }
  // Outlines at a distance do not cross, so one contains the other or they are apart.
  if (room > 0) return !contains(p, q.front() + shift) && !contains(q, p.front() - shift);
  // Narrow equal outlines that coincide may have no other point deep inside each other.
  const auto is_common = [&](const Vec2& at) { return isDeepIn(p, at) && isDeepIn(q, at - shift); };
  return !is_common(first.inner) && !is_common(second.inner + shift) &&
         !reachesInto(p, first.low, first.high, q, shift) &&
         !reachesInto(q, second.low, second.high, p, -shift);
}

struct Extent {
  Vec2 low, high;  ///< cm
};

/// Bounds of the differences at which the boxes of two shapes may meet.
Extent extentOf(const Shape& a, const Shape& b, double gap) {
  const Vec2 more = Vec2::Constant(gap + 0.2);  // parts extend beyond the ring
  return {a.low - b.high - more, a.high - b.low + more};
}

Extent extentOf(const Polyline& ring, double more) {
  Extent extent{ring.front(), ring.front()};
  for (const Vec2& p : ring) {
    extent.low = extent.low.cwiseMin(p);
    extent.high = extent.high.cwiseMax(p);
  }
  extent.low.array() -= more;
  extent.high.array() += more;
  return extent;
}

/// A part of a line, in steps along it.
struct Stretch {
  float from, to;
};

/// Calls add(k, stretch) for each of the lines start + k * next + s * step with its part inside all
/// half planes, each moved outwards.
template <class Add>
void stretchesIn(const std::vector<HalfPlane>& sides, double outwards, const Vec2& start,
                 const Vec2& step, const Vec2& next, const DotRun& lines, Add add) {
  // Store two numbers per side: the s at which the line k = 0 crosses it, and the increment of s
  // from line to line.
  std::vector<double> lower, upper, level;
  for (const HalfPlane& side : sides) {
    const double by = side.normal.dot(step), room = side.at + outwards - side.normal.dot(start);
    const bool is_level = std::abs(by) <= 1e-12;
    const double share = is_level ? 1 : 1 / by;
    std::vector<double>& ends = is_level ? level : by > 0 ? upper : lower;
    ends.push_back(room * share);
    ends.push_back(-side.normal.dot(next) * share);
  }
  constexpr double kFar = 1e6;  // beyond all dots
  for (int k = lines.lo; k <= lines.hi; ++k) {
    double from = -kFar, to = kFar;
    for (std::size_t n = 0; n < lower.size(); n += 2)
      from = std::max(from, lower[n] + k * lower[n + 1]);
    for (std::size_t n = 0; n < upper.size(); n += 2)
      to = std::min(to, upper[n] + k * upper[n + 1]);
    for (std::size_t n = 0; n < level.size(); n += 2)
      if (level[n] + k * level[n + 1] < 0) to = -kFar;
    // a side that is nearly level crosses the line farther away than an int can say
    add(k,
        Stretch{static_cast<float>(std::min(from, kFar)), static_cast<float>(std::max(to, -kFar))});
  }
}

struct Cells {
  DotRun rows, columns;
};

Cells cellsOf(const Extent& extent, const Vec2& offset, const Board& board) {
  Cells cells{{1 << 29, -(1 << 29)}, {1 << 29, -(1 << 29)}};
  for (const double x : {extent.low.x(), extent.high.x()}) {
    for (const double y : {extent.low.y(), extent.high.y()}) {
      const Vec2 steps = board.steps(Vec2(x, y) - offset);
      cells.columns.lo = std::min(cells.columns.lo, static_cast<int>(std::floor(steps.x())));
      cells.columns.hi = std::max(cells.columns.hi, static_cast<int>(std::ceil(steps.x())));
      cells.rows.lo = std::min(cells.rows.lo, static_cast<int>(std::floor(steps.y())));
      cells.rows.hi = std::max(cells.rows.hi, static_cast<int>(std::ceil(steps.y())));
    }
  }
  return cells;
}

/// Union of overlapping stretches on parallel lines of dots, for the depth of each dot inside.
class Unions {
 public:
  Unions(int lines, int dots)
      : dots_(dots), ends_(static_cast<std::size_t>(lines) * dots, {1e9f, -1e9f}) {}

  void add(int line, const Stretch& stretch) {
    const int lo = std::max(0, static_cast<int>(std::ceil(stretch.from)));
    const int hi = std::min(dots_ - 1, static_cast<int>(std::floor(stretch.to)));
    if (hi < lo) return;
    Stretch* ends = lineAt(line);
    // Store the stretch at its first dot; merge() extends it to the others.
    ends[lo].from = std::min(ends[lo].from, stretch.from);
    ends[lo].to = std::max(ends[lo].to, stretch.to);
  }

  void merge() {
    for (std::size_t line = 0; line < ends_.size() / dots_; ++line) {
      Stretch* ends = lineAt(static_cast<int>(line));
      Stretch at{0, -1e9f};
      for (int k = 0; k < dots_; ++k) {
        const Stretch& begun = ends[k];
        if (begun.to >= begun.from) {
          if (at.to < begun.from) at = begun;
          at.to = std::max(at.to, begun.to);
        }
        ends[k] = static_cast<float>(k) <= at.to ? at : Stretch{1e9f, -1e9f};
      }
      for (int k = dots_ - 2; k >= 0; --k)  // the last dot of a union has its end
        if (ends[k].from == ends[k + 1].from) ends[k].to = ends[k + 1].to;
    }
  }

  /// Distance to the nearer end, in steps; negative outside.
  float inside(int line, int dot) const {
    const Stretch& ends = ends_[static_cast<std::size_t>(line) * dots_ + dot];
    return std::min(static_cast<float>(dot) - ends.from, ends.to - static_cast<float>(dot));
  }

 private:
  Stretch* lineAt(int line) { return ends_.data() + static_cast<std::ptrdiff_t>(line) * dots_; }
  int dots_;
  std::vector<Stretch> ends_;
};

}  // namespace

double tableCells(const Shape& first, const Shape& second, const Board& board, double gap) {
  const Cells cells = cellsOf(extentOf(first, second, gap), Vec2::Zero(), board);
  return static_cast<double>(cells.rows.size()) * cells.columns.size();
}

DifferenceTable::DifferenceTable(const Shape& first, const Shape& second, const Vec2& offset,
                                 const Board& board, const Spacing& spacing) {
  // The distance of pieces is that of their middles.
  const Vec2 between = second.middle() - first.middle();
  const Vec2 far = (first.high - first.low) + (second.high - second.low);
  const double most_gap = spacing.gap + spacing.repeat_tolerance * far.norm();
  const auto gapAt = [&](const Vec2& d) {
    return spacing.gap + spacing.repeat_tolerance * (d + between).norm();
  };
  const Cells cells = cellsOf(extentOf(first, second, most_gap), offset, board);
  row0_ = cells.rows.lo;
  rows_ = cells.rows.size();
  column0_ = cells.columns.lo;
  columns_ = cells.columns.size();
  const auto along = static_cast<float>(board.along.norm()),
             up = static_cast<float>(board.up.norm());
  Unions across(rows_, columns_), upwards(columns_, rows_);
  const double room = most_gap - kTouching;
  // If no gap is required, rough parts are smaller by kTouching and hide overlaps along long edges.
  const bool is_tight = spacing.is_exact && room <= 0;
  Unions near(is_tight ? rows_ : 0, columns_);
  for (const Polyline& a : first.parts) {
    for (const Polyline& b : second.parts) {
      const Polyline sum = convexDifference(a, b);
      const std::vector<HalfPlane> sides = halfPlanes(sum);
      const Cells held = cellsOf(extentOf(sum, most_gap), offset, board);
      const Vec2 start = offset + board.shift({column0_, row0_});
      stretchesIn(sides, room, start, board.along, board.up,
                  {held.rows.lo - row0_, held.rows.hi - row0_},
                  [&](int j, const Stretch& stretch) { across.add(j, stretch); });
      stretchesIn(sides, room, start, board.up, board.along,
                  {held.columns.lo - column0_, held.columns.hi - column0_},
                  [&](int i, const Stretch& stretch) { upwards.add(i, stretch); });
      if (is_tight) {
        stretchesIn(sides, most_gap + kHidden, start, board.along, board.up,
                    {held.rows.lo - row0_, held.rows.hi - row0_},
                    [&](int j, const Stretch& stretch) { near.add(j, stretch); });
      }
    }
  }
  across.merge();
  upwards.merge();
  near.merge();
  depths_.resize(static_cast<std::size_t>(rows_) * columns_);
  const double doubtful = kDoubtful + 2 * most_gap;
  for (int j = 0; j < rows_; ++j) {
    for (int i = 0; i < columns_; ++i) {
      const float depth = std::min(across.inside(j, i) * along, upwards.inside(i, j) * up);
      if (depth < 0 && !(is_tight && near.inside(j, i) >= 0)) continue;
      if (spacing.is_exact && depth < doubtful) {
        const Vec2 d = offset + board.shift({column0_ + i, row0_ + j});
        if (areApart(first, second, d, gapAt(d))) continue;
      }
      depths_[place(j, i)] =
          static_cast<std::uint16_t>(std::min(1 + std::max(depth, 0.0f) / kUnit, 60000.0));
    }
  }
}

DifferenceTable DifferenceTable::reversed() const {
  DifferenceTable other = *this;
  other.row0_ = -(row0_ + rows_ - 1);
  other.column0_ = -(column0_ + columns_ - 1);
  std::reverse(other.depths_.begin(), other.depths_.end());
  return other;
}

}  // namespace seamwise
