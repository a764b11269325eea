#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome.h"
#include "drape/worn_garment.h"

namespace seamwise {

/// Reads the input of a drape from a seamwise-result/1 in a file called `file`: pieces as drafted
/// and as cut, seams, symmetries, and the placement of the pieces on the body.
/// Errors: kNotAGarment, kNumber, kNotJson, kTooLarge, naming the file and the piece or seam.
Outcome<SolvedGarment> readSolved(std::string_view text, const std::string& file);

/// Reads named measurements of a body, in cm.
/// Errors: as for readSolved(), naming the file and the measurement.
Outcome<std::vector<BodyMeasure>> readBody(std::string_view text, const std::string& file);

}  // namespace seamwise
