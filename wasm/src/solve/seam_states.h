#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "problem/seam_groups.h"
#include "solve/result.h"

namespace seamwise {

/// Computes the states of a result's seams from its shapes and alignments. Page, files and command
/// line report them.
/// @param group   the symmetries that may join the print across a seam
/// @param match   match problem of the pieces as drafted
/// @param reach   greatest movement of an outline vertex. [cm]
std::vector<GroupFigures> seamStates(const WallpaperGroup& group, const MatchProblem& match,
                                     const std::vector<EdgeRef>& locked,
                                     const std::vector<SeamGroup>& groups, double reach,
                                     const Result& result);

}  // namespace seamwise
