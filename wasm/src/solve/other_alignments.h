#pragma once
#include <vector>

#include "methods/run.h"
#include "solve/result.h"

namespace seamwise {

/// Of the alignments that a search has compared at its end, those that fit about as well as the
/// result and show another part of the print on some piece. The expected best first; each differs
/// from the result, and from the others, in some piece by half a centimetre of print or more.
/// @param group   the symmetries by which the print may meet
/// @param rest    the pieces as drafted
/// @param at      of the result, and where its search ended
/// @param found   what was compared, of all pieces
/// @param reach   how far an outline vertex may move. [cm]
std::vector<OtherAlignment> otherAlignments(const WallpaperGroup& group, const Pattern& pattern,
                                            const Shapes& rest, const std::vector<Alignments>& at,
                                            const std::vector<Alignments>& found, double reach);

}  // namespace seamwise
