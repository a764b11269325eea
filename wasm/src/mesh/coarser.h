#pragma once
#include <optional>

#include "pattern/pattern.h"

namespace seamwise {

/// A pattern with fewer vertices on its outlines, on which most of a deformation can be done: the
/// vertices left out follow their neighbours. Pieces, seams and mirrors are those of the finer one.
struct CoarserPattern {
  /// Where a vertex of the finer outline lies between two neighbours of the coarser one.
  struct Place {
    int from, to;
    double share;  ///< of the way from `from` to `to`, 0 at a vertex that was kept
  };
  Pattern pattern;                         ///< meshed
  std::vector<std::vector<Place>> places;  ///< per piece, per vertex of its outline and cut-outs
};

/// Leaves out vertices along edges while no outline edge gets longer than `longest` cm and no bend
/// sharp; both sides of a seam and mirror images lose the same ones. Empty when there is little to
/// leave out, or what is left cannot be meshed.
std::optional<CoarserPattern> coarsened(const Pattern& fine, double longest);

}  // namespace seamwise
