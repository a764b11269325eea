#pragma once
#include <optional>
#include <string>

#include "drape/form.h"
#include "pattern/garment.h"
#include "pattern/pattern.h"

namespace seamwise {

/// Girth at which a garment is narrowest relative to a body.
struct MissingGirth {
  const MeasureName* measure;  ///< measurement of the body at that height
  double missing;              ///< body less garment, cm
  const Size* fits;            ///< largest size that the garment fits everywhere, or null
};

/// Compares the closed rings of a garment, as cut, with the sections of a body at the same heights.
/// It returns nothing if the garment is nowhere narrower than the body.
/// @param garment   placed on the form
std::optional<MissingGirth> missingGirth(const Garment& garment, const Pattern& pattern,
                                         const Form& form);

/// Returns a sentence without its end, such as " by 4 cm at the hip (it fits size S)".
std::string spoken(const MissingGirth& girth);

}  // namespace seamwise
