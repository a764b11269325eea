#pragma once
#include <vector>

#include "base/outcome.h"
#include "drape/form.h"
#include "drape/placed_piece.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Pieces hung around a body, and which part of it each hangs on; legs are left to their heights.
struct PlacedPieces {
  std::vector<PlacedPiece> placed;
  std::vector<BodyPart> parts;
  double held = 0;  ///< height of the form that they were hung by, its nape's or its waist's, cm
};

/// Hangs the pieces of a garment whose file does not say where they hang, by their seams and, where
/// those leave it open, by their names and by how they are drawn. Upright along their grain, pieces
/// that are sewn side by side or one above the other are laid flat side by side, and that is wound
/// about the torso with the front's axis ahead. Closed tubes that have a twin, but are not sewn to
/// it, are sleeves, and so is what is called so. What has sleeves or shoulder seams hangs from the
/// neck, all else from the waist.
/// Errors: kNotAGarment, naming a piece that no seam joins to the others.
Outcome<PlacedPieces> placedBySeams(const Garment& garment, const Pattern& pattern,
                                    const Form& form);

}  // namespace seamwise
