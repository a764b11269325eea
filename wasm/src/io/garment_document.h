#pragma once
#include <string>
#include <string_view>

#include "base/outcome.h"

namespace seamwise {

/// Converts a garment of any readable format into a document for viewing and editing.
/// web/src/model/garment/garment-document.ts specifies its members: lengths in centimetres, pieces
/// face side up with counter-clockwise outlines, edges with their own points, and numbered seams.
/// Members unknown to this program are copied unchanged. The document lists the open questions of
/// its file. Errors: as for readGarment().
Outcome<std::string> garmentDocument(std::string_view text, const std::string& file);

}  // namespace seamwise
