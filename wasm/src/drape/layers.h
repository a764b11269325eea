#pragma once
#include <vector>

#include "drape/contacts.h"
#include "drape/parts.h"
#include "drape/wrap.h"

namespace seamwise {

/// Returns which pieces cover which. A piece without seams covers the piece that it is matched
/// with. The right one of two overlapping fronts covers the left one.
std::vector<Overlap> overlapsOf(const Garment& garment, const Pattern& pattern,
                                const Hanging& hanging);

/// Places pieces without seams on the pieces that they are matched with. Their match lines coincide
/// in the least-squares sense.
/// @param gap   distance between the two pieces, cm
void layOnOthers(const Garment& garment, const Pattern& pattern,
                 const std::vector<Overlap>& overlaps, double gap, PiecePositions* positions);

}  // namespace seamwise
