#pragma once
#include <optional>

#include "pattern/pattern.h"

namespace seamwise {

/// A pattern with fewer vertices on its outlines, sufficient for most of a deformation. Removed
/// vertices follow their neighbours. Pieces, seams and mirrors are those of the finer pattern.
struct CoarserPattern {
  /// Position of a vertex of the finer outline between two neighbours of the coarser one.
  struct Place {
    int from, to;
    double share;  ///< fraction of the way from `from` to `to`, 0 at a vertex that was kept
  };
  Pattern pattern;                         ///< meshed
  std::vector<std::vector<Place>> places;  ///< per piece, per vertex of its outline and cut-outs
};

/// Removes vertices along edges while no outline edge gets longer than `longest` cm and no bend
/// sharp. Both sides of a seam, and mirror images, lose the same vertices. Returns nothing if few
/// vertices can be removed or the rest cannot be meshed.
std::optional<CoarserPattern> coarsened(const Pattern& fine, double longest);

}  // namespace seamwise
