#pragma once
#include <array>
#include <vector>

#include "photo/lattice/autocorrelation.h"

namespace seamwise {

/// Shift at which an image is more similar to itself than at all neighbouring shifts.
struct CorrelationPeak {
  Vec2 at = Vec2::Zero();  ///< shift with subpixel precision
  double r = 0;
};

/// Returns the maxima of an autocorrelation beyond `shortest` pixels. A maximum ranks by the
/// distance within which nothing is higher (the region of dominance of Liu, Collins and Tsin 2004).
std::vector<CorrelationPeak> dominantPeaks(const Autocorrelation& correlation, double shortest,
                                           int most);

/// Lattice that explains an autocorrelation.
struct VotedLattice {
  std::array<Vec2, 2> basis;  ///< Lagrange-reduced. [pixels]
  double score = 0;           ///< mean r at ten of its points
  bool is_stripes = false;    ///< the second vector runs along the stripes and has any length
};

/// Returns the best lattices of all pairs of peaks, those with high r at all their points. Smaller
/// cells come first among these. Lattices that differ by less than 3 % are returned once.
std::vector<VotedLattice> voteLattices(const Autocorrelation& correlation, double shortest,
                                       int most);

/// Returns stripes: r stays high along a whole line through 0, and the first vector is the period
/// across it.
std::vector<VotedLattice> voteStripes(const Autocorrelation& correlation, double shortest);

}  // namespace seamwise
