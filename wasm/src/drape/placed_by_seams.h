#pragma once
#include <vector>

#include "base/outcome.h"
#include "drape/form.h"
#include "drape/placed_piece.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Pieces placed around a body, and the body part of each. Legs are not assigned here, because
/// their heights decide.
struct PlacedPieces {
  std::vector<PlacedPiece> placed;
  std::vector<BodyPart> parts;
  double held = 0;  ///< height of the form's nape or waist that the pieces hang from, cm
};

/// Places the pieces of a garment whose file has no placements, by its seams.
/// Piece names and the way pieces are drawn resolve ambiguities. Pieces sewn side by side or one
/// above the other are arranged flat, upright along their grain. The flat layout is wound around
/// the torso with the front's axis ahead. Sleeves are closed tubes with a twin that they are not
/// sewn to, and pieces named as sleeves. A garment with sleeves or shoulder seams hangs from the
/// neck, any other from the waist.
/// Errors: kNotAGarment, naming a piece that no seam joins to the others.
Outcome<PlacedPieces> placedBySeams(const Garment& garment, const Pattern& pattern,
                                    const Form& form);

}  // namespace seamwise
