#pragma once
#include <vector>

#include "alignment/model/alignment.h"
#include "pattern/pattern.h"
#include "wallpaper/group.h"

namespace seamwise {

/// The transfer of the print across one seam: one symmetry of the print for its whole length.
struct Join {
  Element element;  ///< lattice shift included in `a`: x = A y + a joins side b to side a
  double cost = 0;  ///< sum of l_e |x_e - (A y_e + a)| over edge midpoints, cm2
  bool mirrored() const { return element.mirrored; }
};

/// The cheapest join of a seam. Candidates are, for each coset, the lattice shift nearest to the
/// weighted mean of x - A y - a, and its eight neighbours.
/// @param continuous_only   forbid orientation-reversing elements
Join bestJoin(const WallpaperGroup& group, const Seam& seam, const Shapes& shapes,
              const std::vector<Alignment>& at, bool continuous_only = false);

/// |x_e - g y_e| of every edge of the seam. [cm]
std::vector<double> joinMismatch(const Join& join, const Seam& seam, const Shapes& shapes,
                                 const std::vector<Alignment>& at);

/// Per edge of a seam: midpoints of both sides in print space, and the sides' mean length. [cm]
struct SeamMidpoints {
  std::vector<Vec2> x, y;  ///< midpoints of side a and of side b
  std::vector<double> length;
};
SeamMidpoints seamMidpoints(const Seam& seam, const Shapes& shapes,
                            const std::vector<Alignment>& at);

}  // namespace seamwise
