#pragma once
#include <string>
#include <string_view>

#include "base/outcome.h"

namespace seamwise {

/// A garment of any readable format as a document for people and programs that look at it or change
/// it, of which web/src/model/garment-document.ts says what it holds: centimetres, pieces face side
/// up and their outlines counter-clockwise, edges with their own points, seams by number, and
/// members unknown to this program as they are. Questions that its file leaves open come with it.
/// Errors: as for readGarment().
Outcome<std::string> garmentDocument(std::string_view text, const std::string& file);

}  // namespace seamwise
