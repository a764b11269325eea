#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome.h"
#include "io/json_input.h"
#include "symmetry/symmetry.h"

namespace seamwise {

/// Reads {"symmetries": [{"kind": "piece" | "pair", ...}]} from a file called `file`. Points in cm,
/// in the input panel's coordinates; names are resolved when the requests are registered. Errors:
/// kSymmetryMalformed naming the entry, kNotJson, kTooLarge.
Outcome<std::vector<SymmetryRequest>> readSymmetries(std::string_view text,
                                                     const std::string& file);

/// Symmetries found on a garment, in the form that readSymmetries reads; `residual` in cm, `map` as
/// p' = R F p + t in face-up coordinates.
std::string writeSymmetries(const Garment& garment, const std::vector<BodySymmetry>& symmetries);

/// The same for requests that were measured; `mirrors` says whether they can be imposed.
std::string writeMeasured(const Garment& garment, const std::vector<MeasuredSymmetry>& measured);

/// The list itself; of no use after a defect.
std::vector<SymmetryRequest> readSymmetryList(const JsonValue& json, const Place& place);

}  // namespace seamwise
