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
  double unit_cm = 1;                       ///< centimetres per unit of the file
};

/// A unit of length that files use: how many of it a metre has, and what it is called.
struct LengthUnit {
  double per_metre;
  const char* name;
};
/// Length units in which a piece has a wearable size.
/// @param extent_cm   its greatest width or height, with so many units in a metre
std::vector<LengthUnit> likelyUnits(double extent_cm, double per_metre);
/// Whether anybody could wear a garment whose tallest piece has this height.
bool isWearable(double height_cm);

/// Reads a GarmentCode / Garment-Pattern-Generator specification or the project's own superset of
/// it, seamwise-garment/1, from a file called `file`. Panels keep the order of the file; a panel
/// whose loop runs clockwise shows its back and is turned face up (x negated, curves included).
/// Errors: those of Failure's garment file section; each names the file and the panel, edge or
/// stitch.
Outcome<GarmentFile> readGarment(std::string_view text, const std::string& file);

/// The same of a document; of no use after a defect. `place` names the file.
GarmentFile readGarmentFile(const JsonValue& document, const Place& place);
/// How a garment's place reports defects.
Place garmentPlace(const std::string& file);

}  // namespace seamwise
