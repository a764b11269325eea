#include "mesh/grading.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tuning/mesh.h"

namespace seamwise {
namespace {

constexpr int kMostCells = 1 << 20;
constexpr int kMostLevels = 16;

}  // namespace

/// A background grid: each cell has the source that determines its spacing, and discs to keep clear
/// of.
struct Grading::Grid {
  Vec2 low;
  double cell;
  int columns, rows;
  std::vector<int> source;              // source that determines the spacing at the cell's middle
  std::vector<std::vector<int>> local;  // sources in the cell and in those around it
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
      reach_.push_back(std::min(length, (a - before).norm()));
    }
  }
}

double Grading::spacingAt(const Vec2& p) const {
  double least = coarsest_;
  for (const Source& s : sources_)
    least = std::min(least, s.spacing + MeshTuning::kGrowth * (p - s.at).norm());
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

/// A hexagonal pattern of points: origin + i b1 + j b2.
struct Grading::Pattern {
  Vec2 b1, b2, origin;
  bool thirds;  // omits the points of the next coarser pattern

  double spacing() const { return b1.norm(); }
  Pattern finer() const { return {(b1 + b2) / 3, (2 * b2 - b1) / 3, origin, true}; }
};

double Grading::gridSpacing(const Grid& grid, const Vec2& p) const {
  const std::size_t cell = grid.index(grid.column(p.x()), grid.row(p.y()));
  double least = coarsest_;
  const auto consider = [&](int source) {
    const Source& s = sources_[source];
    least = std::min(least, s.spacing + MeshTuning::kGrowth * (p - s.at).norm());
  };
  consider(grid.source[cell]);
  for (const int source : grid.local[cell]) consider(source);
  return least;
}

bool Grading::scatter(const Grid& grid, const Pattern& pattern, const Vec2& low, double size,
                      double widest, std::vector<Vec2>& found) const {
  const Vec2 middle = low + Vec2::Constant(size / 2);
  if (gridSpacing(grid, middle) - MeshTuning::kGrowth * size * std::sqrt(0.5) > widest)
    return false;
  if (size > 6 * pattern.spacing()) {
    bool used = false;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(0.5, 0), Vec2(0, 0.5), Vec2(0.5, 0.5)})
      used |= scatter(grid, pattern, low + size * corner, size / 2, widest, found);
    return used;
  }
  // The lattice coordinates of the square's corners bound those of its points.
  const Vec2 from = low - pattern.origin;
  const double det = cross(pattern.b1, pattern.b2);
  Vec2 least = Vec2::Constant(std::numeric_limits<double>::max()), most = -least;
  for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
    const Vec2 q = from + size * corner;
    const Vec2 ij = Vec2(cross(q, pattern.b2), cross(pattern.b1, q)) / det;
    least = least.cwiseMin(ij);
    most = most.cwiseMax(ij);
  }
  for (int i = static_cast<int>(std::ceil(least.x())); i <= most.x(); ++i)
    for (int j = static_cast<int>(std::ceil(least.y())); j <= most.y(); ++j) {
      if (pattern.thirds && (i - j) % 3 == 0) continue;
      const Vec2 q = i * pattern.b1 + j * pattern.b2 - from;
      if (q.minCoeff() < 0 || q.maxCoeff() >= size) continue;
      const Vec2 p = low + q;
      if (grid.isClear(p) && gridSpacing(grid, p) <= widest) found.push_back(p);
    }
  return true;
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
    return sources_[source].spacing + MeshTuning::kGrowth * (p - sources_[source].at).norm();
  };
  const auto offer = [&](int x, int y, int source) {
    int& own = g.source[g.index(x, y)];
    const Vec2 p = g.middle(x, y);
    if (source != own && spacing(source, p) < spacing(own, p)) own = source;
  };
  g.local.resize(g.source.size());
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const int x = g.column(sources_[i].at.x()), y = g.row(sources_[i].at.y());
    for (int v = std::max(0, y - 1); v <= std::min(g.rows - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(g.columns - 1, x + 1); ++u) {
        offer(u, v, static_cast<int>(i));
        g.local[g.index(u, v)].push_back(static_cast<int>(i));
      }
  }
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
    grid.keepClear(corners_[i], MeshTuning::kVertexClear * std::min(reach_[i], coarsest_));
  for (const Source& s : sources_) grid.keepClear(s.at, MeshTuning::kEdgeClear * s.spacing);
  for (const Source& s : sources_) {
    const Vec2 p = s.at + MeshTuning::kRowHeight * s.spacing * s.inward;
    if (!grid.isClear(p)) continue;
    found.push_back(p);
    grid.keepClear(p, MeshTuning::kRowClear * s.spacing);
  }

  // Each hexagonal pattern divides the one before into thirds (spacing / sqrt 3), so it contains
  // every coarser one. A point of pattern k stays where the spacing requires pattern k or a finer
  // one.
  Pattern pattern{Vec2(coarsest_, 0), coarsest_ * unit(kPi / 3),
                  grid.low + Vec2(grid.columns, grid.rows) * (grid.cell / 2), false};
  for (int k = 0; k < kMostLevels; ++k) {
    // The k-th pattern serves spacings up to 3^(1/4) times its own.
    const double widest =
        k == 0 ? std::numeric_limits<double>::infinity() : pattern.spacing() * std::pow(3.0, 0.25);
    const double size = grid.cell * std::max(grid.columns, grid.rows);
    if (!scatter(grid, pattern, grid.low, size, widest, found)) break;
    pattern = pattern.finer();
  }
  return found;
}

}  // namespace seamwise
