#pragma once
#include "drape/form.h"
#include "drape/parts.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Ties bands whose ends go on beyond where they meet behind the body, as those of aprons do: there
/// each end is folded down, and the edges that then hang beside each other are sewn together for
/// the length of a knot. Adds those seams to the pattern; Ring lays what is tied so.
/// @param hanging   of the pieces of the pattern
void tieBands(const Hanging& hanging, const Form& form, Pattern* pattern);

/// Where the band that a seam ties is folded down: so far from its middle, along it, in lengths of
/// `flat`; 0 where the seam ties none.
/// @param flat   (across, level) per vertex of the piece
double tiedAt(const Seam& seam, const std::vector<Vec2>& flat);

}  // namespace seamwise
