#pragma once
#include <vector>

#include "geometry/vec2.h"

namespace seamwise {

/// Spacing of mesh vertices: that of the outline's vertices at the outline, growing with the
/// distance from it. [cm]
class Grading {
 public:
  /// @param coarsest  upper bound, cm
  Grading(const std::vector<Vec2>& points, const std::vector<std::vector<int>>& loops,
          double coarsest);

  double spacingAt(const Vec2& p) const;
  /// Vertices strictly between a and b on a straight line, at distances of spacingAt().
  std::vector<Vec2> spaced(const Vec2& a, const Vec2& b) const;
  /// Candidates for interior vertices of the region inside the loops: a row facing every outline
  /// edge, then a graded hexagonal pattern at a distance from outline and row. Consecutive
  /// candidates are neighbours. Some may be outside.
  std::vector<Vec2> candidates() const;

 private:
  struct Source {
    Vec2 at;         // middle of an outline edge
    Vec2 inward;     // unit normal
    double spacing;  // length of the edge
  };
  struct Grid;
  struct Pattern;
  Grid makeGrid() const;
  /// Computes spacingAt() from the sources that the grid stores, which is much faster.
  double gridSpacing(const Grid& grid, const Vec2& p) const;
  /// Adds a pattern's points in a square where the spacing is at most `widest`. Returns false if
  /// the spacing is greater everywhere.
  bool scatter(const Grid& grid, const Pattern& pattern, const Vec2& low, double size,
               double widest, std::vector<Vec2>& found) const;

  std::vector<Source> sources_;
  std::vector<Vec2> corners_;  // all loop vertices
  std::vector<double> reach_;  // shorter of the two edges at each corner
  double coarsest_;
};

}  // namespace seamwise
