#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome.h"
#include "drape/worn_garment.h"

namespace seamwise {

/// Reads what a drape needs of a seamwise-result/1 in a file called `file`: pieces as drafted and
/// as cut, seams, symmetries, and how the pieces are worn.
/// Errors: kNotAGarment, kNumber, kNotJson, kTooLarge, naming the file and the piece or seam.
Outcome<SolvedGarment> readSolved(std::string_view text, const std::string& file);

/// Reads measurements of a body, by name, in cm.
/// Errors: as above, naming the file and the measurement.
Outcome<std::vector<BodyMeasure>> readBody(std::string_view text, const std::string& file);

}  // namespace seamwise
