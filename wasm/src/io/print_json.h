#pragma once
#include <string>
#include <string_view>

#include "base/outcome.h"
#include "wallpaper/print.h"

namespace seamwise {

/// Reads a print, seamwise-print/1 (`format` is optional): group, w1 and w2 in cm, oneWay. The
/// image, its cell and the fabric are for the viewer; only their types are checked.
/// Errors: kNotAPrint, kGroupUnknown, kLattice, kNotJson, kTooLarge; each names the file and the
/// field.
Outcome<Print> readPrint(std::string_view text, const std::string& file);

}  // namespace seamwise
