#pragma once
#include <array>
#include <vector>

#include "recognition/lattice/autocorrelation.h"

namespace seamwise {

/// A place where a picture is more like itself than all around.
struct CorrelationPeak {
  Vec2 at = Vec2::Zero();  ///< shift, to a part of a pixel
  double r = 0;
};

/// The maxima of an autocorrelation beyond `shortest` pixels, those first that are higher than all
/// else within the widest distance (the region of dominance of Liu, Collins and Tsin 2004).
std::vector<CorrelationPeak> dominantPeaks(const Autocorrelation& correlation, double shortest,
                                           int most);

/// A lattice that explains an autocorrelation.
struct VotedLattice {
  std::array<Vec2, 2> basis;  ///< Lagrange-reduced. [pixels]
  double score = 0;           ///< mean r at ten of its points
  bool is_stripes = false;    ///< the second vector is one along the stripes, of any length
};

/// Every pair of peaks is a lattice; those best that have high r at all their points, of these the
/// smaller cells first. Lattices that are told apart by less than 3 % are given once.
std::vector<VotedLattice> voteLattices(const Autocorrelation& correlation, double shortest,
                                       int most);

/// Where r stays high along a whole line through 0, the period across it: stripes.
std::vector<VotedLattice> voteStripes(const Autocorrelation& correlation, double shortest);

}  // namespace seamwise
