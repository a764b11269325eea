#pragma once
#include <vector>

#include "pattern/pattern.h"
#include "seam/join.h"

namespace seamwise {

/// Mean mismatch, per seam, that shaping is likely to leave at these alignments; 0 for seams that
/// do not count. [cm]
/// @param reach   greatest movement of an outline vertex. [cm]
std::vector<double> predictedMismatches(const WallpaperGroup& group, const Pattern& pattern,
                                        const std::vector<Alignment>& at, double reach);

}  // namespace seamwise
