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

/// The body on which the garment has ease at every height: a size M whose girths are made smaller
/// where rings of pieces are. What has no shoulders is held where it ends: its body is as wide
/// there as it is itself. Errors: those of hang().
Outcome<FittingForm> fittingForm(const Garment& garment, const Pattern& pattern);

}  // namespace seamwise
