#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome.h"
#include "io/json_input.h"
#include "symmetry/symmetry.h"

namespace seamwise {

/// Reads {"symmetries": [{"kind": "piece" | "pair", ...}]} from a file called `file`. Points are in
/// cm, in the input panel's coordinates. Names are resolved when the requests are registered.
/// Errors: kSymmetryMalformed naming the entry, kNotJson, kTooLarge.
Outcome<std::vector<SymmetryRequest>> readSymmetries(std::string_view text,
                                                     const std::string& file);

/// Writes a garment's symmetries in the format of readSymmetries(): `residual` in cm, `map` as
/// p' = R F p + t in face-up coordinates.
std::string writeSymmetries(const Garment& garment, const std::vector<BodySymmetry>& symmetries);

/// Writes measured requests in the same format; `mirrors` is true if they can be imposed.
std::string writeMeasured(const Garment& garment, const std::vector<MeasuredSymmetry>& measured);

/// Reads the list of a garment or symmetry file. The returned value is unusable after a defect.
std::vector<SymmetryRequest> readSymmetryList(const JsonValue& json, const Place& place);

}  // namespace seamwise
