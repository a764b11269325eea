#pragma once
#include <string>
#include <string_view>

#include "base/outcome.h"
#include "wallpaper/print.h"

namespace seamwise {

/// Reads a print, seamwise-print/1 (`format` may be left out): group, w1 and w2 in cm, oneWay. The
/// image, its cell and the fabric are for the viewer; they are checked for type only.
/// Errors: kNotAPrint, kGroupUnknown, kLattice, kNotJson, kTooLarge; each names the file and the
/// field.
Outcome<Print> readPrint(std::string_view text, const std::string& file);

}  // namespace seamwise
