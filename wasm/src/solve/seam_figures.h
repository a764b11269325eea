#pragma once
#include "solve/result.h"
#include "wallpaper/group.h"

namespace seamwise {

/// Computes a result's figures of seams and their means from its shapes, alignments and joins.
/// @param group   the symmetries that may join the print across a seam
/// @param match   match problem of the pieces as drafted
void fillSeamFigures(const WallpaperGroup& group, const MatchProblem& match,
                     const std::vector<EdgeRef>& locked, Result& result);

}  // namespace seamwise
