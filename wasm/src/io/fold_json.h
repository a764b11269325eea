#pragma once
#include "io/panel_json.h"

namespace seamwise {

/// Reads the folds of a panel, whose outline is complete. Defects name the fold: no straight lines,
/// an unknown kind, lines that leave the piece, cross, or lie on each other.
void readFolds(const JsonValue& json, const PanelUnits& units, const Place& place, Panel* panel);

/// Returns the name of a kind in files.
const char* foldKindName(FoldKind kind);

/// Reads the pleats of a piece in a result. Defects name the fold.
std::vector<Fold> readPleats(const JsonValue& json, const Place& place);

}  // namespace seamwise
