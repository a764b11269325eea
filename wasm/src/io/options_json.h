#pragma once
#include <string>
#include <string_view>

#include "base/outcome.h"
#include "pattern/garment.h"
#include "problem/options.h"

namespace seamwise {

/// Reads an options file, which names pieces and numbers seams as the garment file does. Missing
/// fields keep their default. Errors: kOptions naming the file and the field (unknown fields and
/// pieces too), kNotJson, kTooLarge.
Outcome<SolveOptions> readOptions(std::string_view text, const std::string& file,
                                  const Garment& garment);

}  // namespace seamwise
