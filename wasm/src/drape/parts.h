#pragma once
#include <vector>

#include "base/outcome.h"
#include "drape/form.h"
#include "drape/placed_piece.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Placement of a garment on the body.
struct Hanging {
  std::vector<PlacedPiece> placed;  ///< per piece
  std::vector<BodyPart> parts;      ///< per piece
  std::vector<Vec3> middles;        ///< per piece: mean of its placed outline, cm
  std::vector<int> order;           ///< all pieces by position, regardless of the order in the file
  bool by_seams = false;      ///< placedBySeams() placed the pieces, because the file does not
  double held = 0;            ///< PlacedPieces::held if by_seams, cm
  BodyParts covered() const;  ///< parts with a piece, plus torso and neck
};

/// Assigns each piece to a part of the body.
/// Placements decide. Pieces below the crotch without a seam across the middle belong to legs.
/// Pieces along an arm that are tilted like it belong to that arm. Pieces above the shoulders
/// belong to the neck or, if tall, to the head. Files with their origin in the body's middle
/// (Garment-Pattern-Generator) are lifted onto the floor. Seams decide if all pieces have the same
/// placement, as in files without placements (placed_by_seams.h).
/// Errors: kNumber for a placement that is not a number; kNotAGarment for pieces far from any body;
/// those of placedBySeams().
Outcome<Hanging> hang(const Garment& garment, const Pattern& pattern, const Form& form);

/// Returns whether a garment ends below the chest and has pieces only on torso and legs, so that a
/// band holds it.
bool hangsFromWaist(const Hanging& hanging, const Pattern& pattern, const Form& form);

}  // namespace seamwise
