#pragma once
#include <vector>

#include "drape/contacts.h"
#include "drape/parts.h"
#include "drape/wrap.h"

namespace seamwise {

/// Which pieces lie on which: what is sewn to nothing lies on what it is matched with; of two
/// fronts that overlap, the right one lies on the left one.
std::vector<Overlap> overlapsOf(const Garment& garment, const Pattern& pattern,
                                const Hanging& hanging);

/// Lays pieces that are sewn to nothing on those that they are matched with, so that their lines
/// meet, the least squares of what is between them.
/// @param gap   from one to the other, cm
void layOnOthers(const Garment& garment, const Pattern& pattern,
                 const std::vector<Overlap>& overlaps, double gap, PiecePositions* positions);

}  // namespace seamwise
