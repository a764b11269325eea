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
  /// The same, with only those elements that bring the edges' directions within 0.1 rad of the
  /// best.
  double strict = 0;
  /// One element for each whole seam: the visible mismatch.
  double joined = 0;
};

/// All total mismatches of a garment. [cm2]
struct MismatchTotals {
  double total_random = 0;   ///< drafted pieces: mean over random alignments
  double total_drafted = 0;  ///< drafted pieces in the drafted layout
  double total_search = 0;   ///< drafted pieces after the search
  double total_aligned = 0;  ///< drafted pieces at the final alignments
  TotalMismatch total;       ///< final shapes at the final alignments
};

/// TotalMismatch::nearest alone. [cm2]
/// @param at   alignment per piece
double totalMismatch(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
                     const std::vector<Alignment>& at);

/// Cost of the seams that do not match, softly counted by their visible length; 0 if all seams
/// count equally. [cm2]
double unmatchedCost(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
                     const std::vector<Alignment>& at);

/// Cost by which answers compete: unmatchedCost() plus the mismatch by visibility. It is
/// totalMismatch() if all seams count equally. [cm2]
double answerCost(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes,
                  const std::vector<Alignment>& at);

TotalMismatch measureTotal(const WallpaperGroup& group, const Pattern& pattern,
                           const Shapes& shapes, const std::vector<Alignment>& at);

/// Sixty alignments of each of `pieces` pieces, from one fixed sequence, so that the figures of two
/// runs are comparable.
std::vector<std::vector<Alignment>> randomAlignments(const WallpaperGroup& group,
                                                     std::size_t pieces);

/// Mean of totalMismatch() over randomAlignments(). [cm2]
double randomMismatch(const WallpaperGroup& group, const Pattern& pattern, const Shapes& shapes);

/// Greatest movement of an outline vertex of any piece, before or after the piece's best rigid
/// motion, whichever is less. [cm]
double greatestMovement(const Pattern& pattern, const Shapes& shapes);

}  // namespace seamwise
