#pragma once
#include "solve/result.h"
#include "wallpaper/group.h"

namespace seamwise {

/// Fills in a result's figures of seams and their means, from its shapes, alignments and joins.
/// @param group   the symmetries by which the print may meet across a seam
/// @param match   of the pieces as drafted
void fillSeamFigures(const WallpaperGroup& group, const MatchProblem& match,
                     const std::vector<EdgeRef>& locked, Result& result);

}  // namespace seamwise
