#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/outcome.h"
#include "io/json_input.h"
#include "pattern/garment.h"
#include "pattern/note.h"
#include "symmetry/symmetry.h"

namespace seamwise {

/// A garment as it came from a file: what the solver understands of it.
struct GarmentFile {
  Garment garment;
  std::vector<SymmetryRequest> symmetries;  ///< of the file itself; points in input coordinates, cm
  std::vector<Note> notes;                  ///< what was assumed
};

/// Reads a GarmentCode / Garment-Pattern-Generator specification or the project's own superset of
/// it, seamwise-garment/1, from a file called `file`. Panels keep the order of the file; a panel
/// whose loop runs clockwise shows its back and is turned face up (x negated, curves included).
/// Errors: those of Failure's garment file section; each names the file and the panel, edge or
/// stitch.
Outcome<GarmentFile> readGarment(std::string_view text, const std::string& file);

}  // namespace seamwise
