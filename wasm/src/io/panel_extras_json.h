#pragma once
#include <vector>

#include "io/panel_json.h"

namespace seamwise {

/// What seamwise-garment/1 adds to a panel: grain, holes; cut and sew lines and notches are checked
/// and stay in the document. `vertices` in cm as in the file; `panel` has its outline.
void readExtras(const Json& json, const std::vector<Vec2>& vertices, const PanelUnits& units,
                const Place& place, Panel* panel);

/// A closed loop of edges in the file's frame. Throws InputError naming the edge. [cm]
std::vector<Curve> readLoop(const Json& edges, const std::vector<Vec2>& vertices,
                            const PanelUnits& units, const Place& place);

/// "free", "on", "bias".
GrainLock readGrainLock(const Json& json, const Place& place);

/// Degrees between 0 and 90, as radians.
double readGrainTolerance(const Json& json, const Place& place);

}  // namespace seamwise
