#pragma once
#include <vector>

#include "pattern/pattern.h"
#include "seam/join.h"

namespace seamwise {

/// The figures by which results are compared; all sums of edge length times distance, cm2, over the
/// seams that count (matched and not joining a piece to its own mirror twin).
struct Fit {
  double any = 0;  ///< E_fit of Wolff et al. 2019, Sec. 4: each edge with its nearest element
  double strict =
      0;  ///< only elements that also bring the edges' directions within 0.1 rad of the best
  double seam = 0;  ///< one element for the whole seam: what the eye sees
};

/// Every fit of a garment: of the pieces as drafted, and of what was made of them.
struct Fits {
  double fit_random = 0;                   ///< mean over random alignments
  double fit_drafted = 0;                  ///< as a cutter lays them
  double fit_search = 0, fit_aligned = 0;  ///< after the search, and as they lie at last
  Fit fit;                                 ///< shaped, as they lie at last
};

double fitAny(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
              const std::vector<Alignment>& at);
Fit measureFit(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
               const std::vector<Alignment>& at);

/// Sixty alignments of as many pieces, from one fixed sequence, so that the figures of two runs
/// compare.
std::vector<std::vector<Alignment>> randomAlignments(const WallpaperGroup& group,
                                                     std::size_t pieces);

/// The mean of fitAny over random alignments of the shapes.
double fitRandom(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes);

/// Greatest movement of an outline vertex of any piece, as it lies or after the piece's best rigid
/// motion, whichever is less. [cm]
double greatestMovement(const Pattern& pattern, const Shapes& shapes);

}  // namespace seamwise
