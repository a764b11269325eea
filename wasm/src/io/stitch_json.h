#pragma once
#include <string>
#include <vector>

#include "io/json_input.h"
#include "pattern/garment.h"
#include "pattern/note.h"

namespace seamwise {

/// Reads GarmentCode's `stitches` into garment->stitches. Defects name the stitch.
void readStitches(const JsonValue& stitches, const Place& place, Garment* garment);

/// Reads the top-level `seams` of seamwise-garment/1: weight, matched, direction and length ratio
/// of stitches.
void readSeams(const JsonValue& seams, const Place& place, Garment* garment,
               std::vector<Note>* notes);

}  // namespace seamwise
