#pragma once
#include <vector>

#include "base/outcome.h"
#include "drape/form.h"
#include "drape/placed_piece.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// What a garment says about how it is worn.
struct Hanging {
  std::vector<PlacedPiece> placed;  ///< per piece
  std::vector<BodyPart> parts;      ///< per piece
  std::vector<Vec3> middles;        ///< per piece: mean of its placed outline, cm
  std::vector<int> order;           ///< all pieces, by where they hang, whatever the file's order
  bool by_seams = false;            ///< the file says nothing of it: placedBySeams() has it so
  double held = 0;                  ///< of these, PlacedPieces::held
  BodyParts covered() const;        ///< every part that a piece hangs on, and torso and neck
};

/// Which part of the body each piece hangs on. Placements decide: pieces below the crotch that are
/// sewn to nothing across the middle are legs', what lies along an arm and is tilted like it is an
/// arm's, what lies above the shoulders is the neck's or, when tall, the head's. Files whose origin
/// is the body's middle (Garment-Pattern-Generator) are lifted onto the floor. Where all pieces lie
/// at the same place, as in files that place none, their seams decide (placed_by_seams.h).
/// Errors: kNumber for a placement that is no number; kNotAGarment when pieces are placed far from
/// any body; those of placedBySeams().
Outcome<Hanging> hang(const Garment& garment, const Pattern& pattern, const Form& form);

/// Whether a garment ends below the chest and has nothing on arms or head: a band holds it.
bool hangsFromWaist(const Hanging& hanging, const Pattern& pattern, const Form& form);

}  // namespace seamwise
