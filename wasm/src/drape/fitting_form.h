#pragma once
#include "base/outcome.h"
#include "drape/measures.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Body for a garment that states neither a size nor body measurements.
struct FittingForm {
  Measures measures;
  double lift = 0;  ///< cm, raises the garment's placement to the height of this body
};

/// Finds the body on which the garment has ease at every height.
/// The body is a size M or smaller, with girths reduced at rings of pieces. A garment without
/// shoulders is held by its top edge, so its body has the same width there.
/// Errors: those of hang().
Outcome<FittingForm> fittingForm(const Garment& garment, const Pattern& pattern);

}  // namespace seamwise
