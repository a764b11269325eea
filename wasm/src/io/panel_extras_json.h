#pragma once
#include <vector>

#include "io/panel_json.h"

namespace seamwise {

/// What seamwise-garment/1 adds to a panel: grain, holes; cut and sew lines and notches are checked
/// and stay in the document. `vertices` in cm as in the file; `panel` has its outline.
void readExtras(const JsonValue& json, const std::vector<Vec2>& vertices, const PanelUnits& units,
                const Place& place, Panel* panel);

/// A closed loop of edges in the file's frame; empty after a defect, which names the edge. [cm]
std::vector<Curve> readLoop(const JsonValue& json, const std::vector<Vec2>& vertices,
                            const PanelUnits& units, const Place& place);

/// "free", "on", "bias".
GrainLock readGrainLock(const JsonValue& json, const Place& place);

/// Degrees between 0 and 90, as radians.
double readGrainTolerance(const JsonValue& json, const Place& place);

}  // namespace seamwise
