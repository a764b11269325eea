#pragma once
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// How far apart mesh vertices should lie: as the outline's vertices at the outline, growing with
/// the distance from it. [cm]
class Grading {
 public:
  /// @param coarsest  upper bound, cm
  Grading(const std::vector<Vec2>& points, const std::vector<std::vector<int>>& loops,
          double coarsest);

  double spacingAt(const Vec2& p) const;
  /// The vertices strictly between a and b on a straight line, at the distances that spacingAt()
  /// gives.
  std::vector<Vec2> spaced(const Vec2& a, const Vec2& b) const;
  /// Candidates for interior vertices of the region inside the loops, in an order in which
  /// neighbours follow each other: a row facing every outline edge, then a graded hexagonal pattern
  /// that keeps its distance from outline and row. Some may lie outside.
  std::vector<Vec2> candidates() const;

 private:
  struct Source {
    Vec2 at;         // middle of an outline edge
    Vec2 inward;     // unit normal
    double spacing;  // its length
  };
  struct Grid;
  struct Pattern;
  Grid makeGrid() const;
  /// spacingAt() as far as the grid knows, much faster.
  double gridSpacing(const Grid& grid, const Vec2& p) const;
  /// Adds a pattern's points in a square where the spacing is at most `widest`; false when that is
  /// nowhere so.
  bool scatter(const Grid& grid, const Pattern& pattern, const Vec2& low, double size,
               double widest, std::vector<Vec2>& found) const;

  std::vector<Source> sources_;
  std::vector<Vec2> corners_;  // all loop vertices, with ...
  std::vector<double> reach_;  // ... the shorter of their two edges
  double coarsest_;
};

}  // namespace seamwise
