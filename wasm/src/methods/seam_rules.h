#pragma once
#include <cstdint>
#include <vector>

#include "pattern/pattern.h"
#include "seam/join.h"

namespace seamwise {

/// Mean distance of what meets at a seam, modulo the print's group, point by point. [cm]
/// At most the covering radius of the print's lattice.
double localMismatch(const WallpaperGroup& group, const Seam& seam, const Shapes& shapes,
                     const std::vector<Alignment>& at);

/// localMismatch() of every seam; 0 for those that do not count. [cm]
std::vector<double> localMismatches(const WallpaperGroup& group, const Pattern& pattern,
                                    const Shapes& shapes, const std::vector<Alignment>& at);

/// Length of every seam, mean of its sides; 0 for those that do not count. [cm]
std::vector<double> seamLengths(const Pattern& pattern, const Shapes& shapes);

/// Mean of the seams' mismatches by their lengths, whatever they weigh. [cm]
double meanMismatch(const std::vector<double>& mismatches, const std::vector<double>& lengths);

/// Whether a seam counts: matched, and not joining a piece to its own mirror twin.
inline bool counts(const Seam& seam) { return seam.matched && !seam.twin; }

/// The greatest mean that a seam may end with of which placing alone leaves `placed`. [cm]
double greatestMean(double placed);

/// Total mismatch of seams with these means, by their lengths; what exceeds the greatest mean that
/// placing alone allows counts several times more, because no result may end with it. [cm2]
double mismatchUnderRules(const std::vector<double>& mismatches, const std::vector<double>& lengths,
                          const std::vector<double>& placed);

/// Means of one seam: of the pieces as drafted where placing alone lays them, where they lie at
/// last, and of their final shape there. [cm]
struct SeamMeans {
  double placed, aligned, shaped;
};

enum class Verdict : std::uint8_t {
  kKept,    ///< as good as it has to be
  kInVain,  ///< shaping it gains too little: it is to keep its drafted line
  kWorse    ///< worse than by placing alone
};

/// @param moved   how far a vertex of it moved at most, its ends apart. [cm]
Verdict verdictOn(const SeamMeans& means, double moved);

/// Whether shaping may bring a seam below what is worth bending it for, when each side may move by
/// `reach` cm.
/// @param mismatch   per edge as the pieces lie, through the seam's join. [cm]
bool isWithinReach(const std::vector<double>& mismatch, double reach);

/// How far vertices of a seam moved at most, its ends apart. [cm]
double seamMovement(const Seam& seam, const Pattern& pattern, const Shapes& shapes);

}  // namespace seamwise
