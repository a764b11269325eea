#pragma once
#include "base/outcome.h"
#include "drape/measures.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// A body for a garment that says nothing about whom it is drafted for.
struct FittingForm {
  Measures measures;
  double lift = 0;  ///< that brings the garment's placement to the height of this body, cm
};

/// The largest body of size M or less on which the garment has ease at every height, its shoulders
/// at the form's shoulders or, without any, its top edge at the waist. Errors: those of hang().
Outcome<FittingForm> fittingForm(const Garment& garment, const Pattern& pattern);

}  // namespace seamwise
