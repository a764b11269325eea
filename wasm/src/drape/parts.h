#pragma once
#include <vector>

#include "base/outcome.h"
#include "drape/form.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Where a file hangs a piece in space: face-up coordinates to the body's, cm.
struct PlacedPiece {
  Vec3 right, up;  ///< unit vectors: where x and y of the piece point
  Vec3 shift;      ///< cm
  Vec3 operator()(const Vec2& p) const { return right * p.x() + up * p.y() + shift; }
};

/// What a garment says about how it is worn.
struct Hanging {
  std::vector<PlacedPiece> placed;  ///< per piece
  std::vector<BodyPart> parts;      ///< per piece
  std::vector<Vec3> middles;        ///< per piece: mean of its placed outline, cm
  std::vector<int> order;           ///< all pieces, by where they hang, whatever the file's order
  BodyParts covered() const;        ///< every part that a piece hangs on, and torso and neck
};

/// Which part of the body each piece hangs on. Placements decide: pieces below the crotch that are
/// sewn to nothing across the middle are legs', what lies along an arm and is tilted like it is an
/// arm's, what lies above the shoulders is the neck's or, when tall, the head's. Files whose origin
/// is the body's middle (Garment-Pattern-Generator) are lifted onto the floor.
/// Errors: kNumber for a placement that is no number; kNotAGarment when the file places no pieces,
/// all at the same place, or far from any body.
Outcome<Hanging> hang(const Garment& garment, const Pattern& pattern, const Form& form);

/// Whether a garment ends below the chest and has nothing on arms or head: a band holds it.
bool hangsFromWaist(const Hanging& hanging, const Pattern& pattern, const Form& form);

}  // namespace seamwise
