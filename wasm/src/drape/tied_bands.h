#pragma once
#include "drape/form.h"
#include "drape/parts.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Ties bands whose ends extend beyond their meeting point behind the body, such as apron ties.
/// Each end is folded down there. The edges that then hang side by side are sewn together for the
/// length of a knot. The seams are added to the pattern; Ring places tied bands.
/// @param hanging   placement of the pattern's pieces
void tieBands(const Hanging& hanging, const Form& form, Pattern* pattern);

/// Returns the distance from a band's middle at which a seam's band is folded down, in units of
/// `flat`; 0 if the seam ties no band.
/// @param flat   (across, level) per vertex of the piece
double tiedAt(const Seam& seam, const std::vector<Vec2>& flat);

}  // namespace seamwise
