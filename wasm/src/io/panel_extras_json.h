#pragma once
#include <vector>

#include "io/panel_json.h"

namespace seamwise {

/// What seamwise-garment/1 adds to a panel: grain, holes; cut and sew lines and marks are checked
/// and stay in the document. `vertices` in cm as in the file; `panel` has its outline, whose paths
/// are of so many `cubics`.
void readExtras(const JsonValue& json, const std::vector<Vec2>& vertices, const PanelUnits& units,
                const Place& place, Panel* panel, std::size_t cubics);

/// Checks what seamwise-garment/1 adds to an edge: its allowance, and whether it stays open. Both
/// stay in the document.
void checkEdgeExtras(const JsonValue& edge, const PanelUnits& units, const Place& place);

/// A closed loop of edges in the file's frame; empty after a defect, which names the edge. [cm]
/// @param cubics   those of the panel's paths so far, to which its own are added
std::vector<Curve> readLoop(const JsonValue& json, const std::vector<Vec2>& vertices,
                            const PanelUnits& units, const Place& place, std::size_t* cubics);

/// "free", "on", "bias".
GrainLock readGrainLock(const JsonValue& json, const Place& place);

/// Degrees between 0 and 90, as radians.
double readGrainTolerance(const JsonValue& json, const Place& place);

}  // namespace seamwise
