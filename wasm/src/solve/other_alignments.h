#pragma once
#include <vector>

#include "methods/run.h"
#include "solve/result.h"

namespace seamwise {

/// Selects alternatives among the alignments that a search has compared at its end. They fit about
/// as well as the result and show another part of the print on some piece. They are sorted by
/// expected mismatch. Each differs from the result and from the others by half a centimetre of
/// print or more on some piece.
/// @param group   the symmetries that may join the print across seams
/// @param rest    the pieces as drafted
/// @param at      alignments of the result and of the end of its search
/// @param found   the compared alignments, each of all pieces
/// @param reach   greatest movement of an outline vertex. [cm]
std::vector<OtherAlignment> otherAlignments(const WallpaperGroup& group, const Pattern& pattern,
                                            const Shapes& rest, const std::vector<Alignments>& at,
                                            const std::vector<Alignments>& found, double reach);

}  // namespace seamwise
