#pragma once
#include <cstdint>
#include <vector>

#include "pattern/pattern.h"
#include "seam/join.h"

namespace seamwise {

/// Mean distance of the two sides of a seam, modulo the print's group, point by point. [cm] At most
/// the covering radius of the print's lattice.
double localMismatch(const WallpaperGroup& group, const Seam& seam, const Shapes& shapes,
                     const std::vector<Alignment>& at);

/// localMismatch() of every seam; 0 for seams that do not count. [cm]
std::vector<double> localMismatches(const WallpaperGroup& group, const Pattern& pattern,
                                    const Shapes& shapes, const std::vector<Alignment>& at);

/// Share of a seam's length with a mismatch that is seen.
double offShare(const WallpaperGroup& group, const Seam& seam, const Shapes& shapes,
                const std::vector<Alignment>& at);

/// Length of every seam, mean of its sides; 0 for seams that do not count. [cm]
std::vector<double> seamLengths(const Pattern& pattern, const Shapes& shapes);

/// Mean of the seams' mismatches by their lengths, regardless of weights. [cm]
double meanMismatch(const std::vector<double>& mismatches, const std::vector<double>& lengths);

/// Returns whether a seam counts: it is matched, and does not join a piece to its own mirror twin.
inline bool counts(const Seam& seam) { return seam.matched && !seam.twin; }

/// Returns whether a seam may match as a whole, if seams count by their visibility.
inline bool canMatch(const Seam& seam) {
  return counts(seam) && seam.visibility > 0 && !isGathered(seam);
}

/// Weight of a seam's mismatch where answers are compared: its visibility, little if it is
/// gathered, and 1 if all seams count equally.
double costWeight(const Seam& seam);

/// Degree to which a seam does not match, 0 to 1, if this share of its length is off.
double unmatched(double off);

/// The greatest final mean of a seam with mean `placed` by placing alone. [cm] Infinite if the seam
/// is lost there anyway and seams count by their visibility.
/// @param visibility   of the seam; 0: all seams count equally
double greatestMean(double placed, double visibility);

/// Total mismatch of the pattern's seams with these means, by their lengths and costWeight(). The
/// excess over the greatest mean that placing alone allows counts several times more, because no
/// result may end with it. [cm2]
double mismatchUnderRules(const Pattern& pattern, const std::vector<double>& mismatches,
                          const std::vector<double>& lengths, const std::vector<double>& placed);

/// Mean mismatches of one seam: drafted pieces by placing alone, drafted pieces at the final
/// alignments, and final shapes there. [cm]
struct SeamMeans {
  double placed, aligned, shaped;
};

enum class Verdict : std::uint8_t {
  kKept,    ///< good enough
  kInVain,  ///< shaping gains too little, so the seam has to keep its drafted line
  kWorse    ///< worse than by placing alone
};

/// Judges the mismatch of a seam.
/// @param moved   greatest movement of its vertices, ends excluded. [cm]
/// @param visibility   of the seam; 0: all seams count equally
Verdict verdictOn(const SeamMeans& means, double moved, double visibility);

/// Returns whether shaping may reduce a seam's mismatch enough to be worth bending it, if each side
/// may move by `reach` cm.
/// @param mismatch   per edge at these alignments, through the seam's join. [cm]
bool isWithinReach(const std::vector<double>& mismatch, double reach);

/// Greatest movement of a seam's vertices, ends excluded. [cm]
double seamMovement(const Seam& seam, const Pattern& pattern, const Shapes& shapes);

/// The same, after the best rigid motion of each line. [cm]
double seamBend(const Seam& seam, const Pattern& pattern, const Shapes& shapes);

}  // namespace seamwise
