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

/// A garment file, reduced to the data that the solver uses.
struct GarmentFile {
  Garment garment;
  std::vector<SymmetryRequest> symmetries;  ///< those of the file; points in input coordinates, cm
  std::vector<Note> notes;                  ///< assumptions
  double unit_cm = 1;                       ///< centimetres per unit of the file
};

/// A unit of length in files: its number per metre and its name.
struct LengthUnit {
  double per_metre;
  const char* name;
};
/// Length units in which a piece has a wearable size.
/// @param extent_cm   the piece's greatest width or height, measured at `per_metre` units per metre
std::vector<LengthUnit> likelyUnits(double extent_cm, double per_metre);
/// True if a person can wear a garment whose tallest piece has this height.
bool isWearable(double height_cm);

/// Reads a GarmentCode / Garment-Pattern-Generator specification or its superset, this project's
/// seamwise-garment/1, from a file called `file`. Panels keep the order of the file. A panel whose
/// loop runs clockwise shows its back and is turned face up (x negated, curves included).
/// Errors: those of Failure's garment file section; each names the file and the panel, edge or
/// stitch.
Outcome<GarmentFile> readGarment(std::string_view text, const std::string& file);

/// Reads a garment from a parsed document. The returned value is unusable after a defect.
/// @param place   the file
GarmentFile readGarmentFile(const JsonValue& document, const Place& place);
/// The place of a garment file, with the codes of its defects.
Place garmentPlace(const std::string& file);

}  // namespace seamwise
