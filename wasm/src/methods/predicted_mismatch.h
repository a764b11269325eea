#pragma once
#include <vector>

#include "pattern/pattern.h"
#include "seam/join.h"

namespace seamwise {

/// What shaping is likely to leave of each seam's mean mismatch, as the pieces lie; 0 for seams
/// that count in no fit. [cm]
/// @param reach   how far an outline vertex may move. [cm]
std::vector<double> predictedMismatches(const WallpaperGroup& group, const Pattern& pattern,
                                        const std::vector<Alignment>& at, double reach);

}  // namespace seamwise
