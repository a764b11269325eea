#pragma once
#include <vector>

#include "pattern/pattern.h"
#include "seam/join.h"

namespace seamwise {

/// Total mismatch of a garment: sums of edge length times distance over the seams that count
/// (matched and not joining a piece to its own mirror twin). [cm2] Files call these figures `fit`.
struct TotalMismatch {
  /// Each edge with its nearest element: E_fit of Wolff et al. 2019, Sec. 4.
  double nearest = 0;
  /// The same with those elements only that bring the edges' directions within 0.1 rad of the best.
  double strict = 0;
  /// One element for each whole seam: what the eye sees.
  double joined = 0;
};

/// All totals of a garment. [cm2]
struct MismatchTotals {
  double total_random = 0;   ///< of the pieces as drafted: mean over random alignments
  double total_drafted = 0;  ///< the same in the drafted layout
  double total_search = 0;   ///< the same after the search
  double total_aligned = 0;  ///< the same as they lie at last
  TotalMismatch total;       ///< of the shapes, as they lie at last
};

/// TotalMismatch::nearest alone. [cm2]
/// @param at   per piece
double totalMismatch(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
                     const std::vector<Alignment>& at);
TotalMismatch measureTotal(const WallpaperGroup& group, const Pattern& pattern,
                           const Shapes& shapes, const std::vector<Alignment>& at);

/// Sixty alignments of each of `pieces` pieces, from one fixed sequence, so that the figures of two
/// runs compare.
std::vector<std::vector<Alignment>> randomAlignments(const WallpaperGroup& group,
                                                     std::size_t pieces);

/// Mean of totalMismatch() over randomAlignments(). [cm2]
double randomMismatch(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes);

/// Greatest movement of an outline vertex of any piece, as it lies or after the piece's best rigid
/// motion, whichever is less. [cm]
double greatestMovement(const Pattern& pattern, const Shapes& shapes);

}  // namespace seamwise
