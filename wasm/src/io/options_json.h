#pragma once
#include <string>
#include <string_view>

#include "base/outcome.h"
#include "pattern/garment.h"
#include "problem/options.h"

namespace seamwise {

/// Reads an options file; pieces by name, seams by their number in the garment file. Fields that
/// are left out keep their default. Errors: kOptions naming the file and the field (unknown fields
/// and pieces too), kNotJson, kTooLarge.
Outcome<SolveOptions> readOptions(std::string_view text, const std::string& file,
                                  const Garment& garment);

}  // namespace seamwise
