#include "deform/grading.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seamwise {
namespace {

constexpr double kGrowth = 0.4;  // of the spacing, per cm of distance from the outline
constexpr double kRowHeight =
    0.85;  // of an edge's length: its first row of triangles is equilateral
constexpr double kVertexClear = 0.65;  // of the local spacing that no other vertex may lie within
constexpr double kEdgeClear = 0.6;
constexpr double kRowClear = 0.72;
constexpr int kMostCells = 1 << 20;
constexpr int kMostLevels = 12;

}  // namespace

/// A background grid: per cell the source that rules its spacing, and the discs to keep clear of.
struct Grading::Grid {
  Vec2 low;
  double cell;
  int columns, rows;
  std::vector<int> source;
  std::vector<std::vector<std::pair<Vec2, double>>> clear;

  int column(double x) const {
    return std::clamp(static_cast<int>(std::floor((x - low.x()) / cell)), 0, columns - 1);
  }
  int row(double y) const {
    return std::clamp(static_cast<int>(std::floor((y - low.y()) / cell)), 0, rows - 1);
  }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * columns + x; }
  Vec2 middle(int x, int y) const { return low + cell * Vec2(x + 0.5, y + 0.5); }

  void keepClear(const Vec2& p, double radius) {
    for (int y = row(p.y() - radius); y <= row(p.y() + radius); ++y)
      for (int x = column(p.x() - radius); x <= column(p.x() + radius); ++x)
        clear[index(x, y)].emplace_back(p, radius * radius);
  }
  bool isClear(const Vec2& p) const {
    for (const auto& [q, square] : clear[index(column(p.x()), row(p.y()))])
      if ((p - q).squaredNorm() < square) return false;
    return true;
  }
};

Grading::Grading(const std::vector<Vec2>& points, const std::vector<std::vector<int>>& loops,
                 double coarsest)
    : coarsest_(coarsest) {
  for (const auto& loop : loops) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 &a = points[loop[i]], &b = points[loop[(i + 1) % n]];
      const Vec2& before = points[loop[(i + n - 1) % n]];
      const double length = (b - a).norm();
      sources_.push_back({(a + b) / 2, perp(b - a) / length, length});
      corners_.push_back(a);
      reach_.push_back((length + (a - before).norm()) / 2);
    }
  }
}

double Grading::spacingAt(const Vec2& p) const {
  double least = coarsest_;
  for (const Source& s : sources_) least = std::min(least, s.spacing + kGrowth * (p - s.at).norm());
  return least;
}

std::vector<Vec2> Grading::spaced(const Vec2& a, const Vec2& b) const {
  // Integrate 1 / spacing, then cut the integral into equal parts.
  const double length = (b - a).norm();
  double finest = coarsest_;
  for (const Source& s : sources_) finest = std::min(finest, s.spacing);
  const int steps = std::clamp(static_cast<int>(std::ceil(4 * length / finest)), 8, 4000);
  std::vector<double> sum{0};
  for (int k = 0; k < steps; ++k)
    sum.push_back(sum.back() + length / steps / spacingAt(a + (k + 0.5) / steps * (b - a)));
  const int parts = std::max(1, static_cast<int>(std::lround(sum.back())));
  std::vector<Vec2> points;
  for (int i = 1, k = 0; i < parts; ++i) {
    const double target = sum.back() * i / parts;
    while (sum[k + 1] < target) ++k;
    points.push_back(a + (k + (target - sum[k]) / (sum[k + 1] - sum[k])) / steps * (b - a));
  }
  return points;
}

Grading::Grid Grading::makeGrid() const {
  Grid g;
  Vec2 high = corners_.front();
  g.low = high;
  double total = 0;
  for (const Vec2& p : corners_) {
    g.low = g.low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (const Source& s : sources_) total += s.spacing;
  const Vec2 extent = high - g.low;
  g.cell = std::max({std::min(coarsest_, total / static_cast<double>(sources_.size())),
                     std::sqrt(extent.x() * extent.y() / kMostCells),
                     extent.maxCoeff() / kMostCells, 1e-9});
  g.columns = 1 + static_cast<int>(extent.x() / g.cell);
  g.rows = 1 + static_cast<int>(extent.y() / g.cell);
  g.source.assign(g.index(0, g.rows), -1);
  g.clear.resize(g.source.size());

  // Each cell takes the best source of its neighbours, in two sweeps [Danielsson 1980].
  const auto spacing = [&](int source, const Vec2& p) {
    if (source < 0) return std::numeric_limits<double>::infinity();
    return sources_[source].spacing + kGrowth * (p - sources_[source].at).norm();
  };
  const auto offer = [&](int x, int y, int source) {
    int& own = g.source[g.index(x, y)];
    const Vec2 p = g.middle(x, y);
    if (source != own && spacing(source, p) < spacing(own, p)) own = source;
  };
  for (std::size_t i = 0; i < sources_.size(); ++i)
    offer(g.column(sources_[i].at.x()), g.row(sources_[i].at.y()), static_cast<int>(i));
  const auto take = [&](int x, int y, int dx, int dy) {
    const int u = x + dx, v = y + dy;
    if (u >= 0 && u < g.columns && v >= 0 && v < g.rows) offer(x, y, g.source[g.index(u, v)]);
  };
  for (const int dy : {-1, 1}) {
    for (int k = 0; k < g.rows; ++k) {
      const int y = dy < 0 ? k : g.rows - 1 - k;
      for (int x = 0; x < g.columns; ++x)
        for (const int dx : {-1, 0, 1}) take(x, y, dx, dy);
      for (int x = 0; x < g.columns; ++x) take(x, y, -1, 0);
      for (int x = g.columns; x-- > 0;) take(x, y, 1, 0);
    }
  }
  return g;
}

std::vector<Vec2> Grading::candidates() const {
  std::vector<Vec2> found;
  if (sources_.empty()) return found;
  Grid grid = makeGrid();
  for (std::size_t i = 0; i < corners_.size(); ++i)
    grid.keepClear(corners_[i], kVertexClear * std::min(reach_[i], coarsest_));
  for (const Source& s : sources_) grid.keepClear(s.at, kEdgeClear * s.spacing);
  for (const Source& s : sources_) {
    const Vec2 p = s.at + kRowHeight * s.spacing * s.inward;
    if (!grid.isClear(p)) continue;
    found.push_back(p);
    grid.keepClear(p, kRowClear * s.spacing);
  }

  // Hexagonal patterns, each the thirds of the one before (spacing / sqrt 3), so that every coarser
  // one is part of every finer one. A point of pattern k stays where the spacing asks for k or
  // finer.
  Vec2 b1(coarsest_, 0), b2 = coarsest_ * unit(kPi / 3);
  const Vec2 origin = grid.low + Vec2(grid.columns, grid.rows) * (grid.cell / 2);
  const double log3 = std::log(3.0) / 2;
  std::vector<double> level(grid.source.size());
  double finest = 0;
  for (int y = 0; y < grid.rows; ++y)
    for (int x = 0; x < grid.columns; ++x) {
      const Source& s = sources_[grid.source[grid.index(x, y)]];
      const double nearest = std::max(0.0, (grid.middle(x, y) - s.at).norm() - grid.cell);
      double& l = level[grid.index(x, y)];
      l = std::log(coarsest_ / std::min(coarsest_, s.spacing + kGrowth * nearest)) / log3 + 0.5;
      finest = std::max(finest, l);
    }
  const int levels = std::min(kMostLevels, static_cast<int>(finest));
  for (int k = 0; k <= levels; ++k) {
    const double det = cross(b1, b2);
    for (int y = 0; y < grid.rows; ++y)
      for (int x = 0; x < grid.columns; ++x) {
        if (level[grid.index(x, y)] < k) continue;
        const Source& source = sources_[grid.source[grid.index(x, y)]];
        const Vec2 low = grid.low + grid.cell * Vec2(x, y) - origin;
        // The lattice coordinates of the cell's corners bound those of its points.
        double i0 = 1e300, i1 = -1e300, j0 = 1e300, j1 = -1e300;
        for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
          const Vec2 q = low + grid.cell * corner;
          const double i = cross(q, b2) / det, j = cross(b1, q) / det;
          i0 = std::min(i0, i), i1 = std::max(i1, i), j0 = std::min(j0, j), j1 = std::max(j1, j);
        }
        for (int i = static_cast<int>(std::ceil(i0)); i <= i1; ++i)
          for (int j = static_cast<int>(std::ceil(j0)); j <= j1; ++j) {
            if (k > 0 && (i - j) % 3 == 0) continue;  // part of a coarser pattern
            const Vec2 q = i * b1 + j * b2 - low;
            if (q.x() < 0 || q.y() < 0 || q.x() >= grid.cell || q.y() >= grid.cell) continue;
            const Vec2 p = q + low + origin;
            const double spacing =
                std::min(coarsest_, source.spacing + kGrowth * (p - source.at).norm());
            if (std::log(coarsest_ / spacing) / log3 + 0.5 < k) continue;
            if (grid.isClear(p)) found.push_back(p);
          }
      }
    const Vec2 finer = (b1 + b2) / 3;
    b2 = (2 * b2 - b1) / 3;
    b1 = finer;
  }
  return found;
}

}  // namespace seamwise
