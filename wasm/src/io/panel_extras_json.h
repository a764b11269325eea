#pragma once
#include <vector>

#include "io/panel_json.h"

namespace seamwise {

/// Reads the additions of seamwise-garment/1 to a panel: grain, holes and folds. Cut and sew
/// lines and marks are only checked; they stay in the document.
/// @param vertices   those of the file, in cm
/// @param panel      has its outline already
/// @param cubics     number of cubics in the paths of the outline
void readExtras(const JsonValue& json, const std::vector<Vec2>& vertices, const PanelUnits& units,
                const Place& place, Panel* panel, std::size_t cubics);

/// Checks the additions of seamwise-garment/1 to an edge, `allowance` and `open`. Both stay in the
/// document.
void checkEdgeExtras(const JsonValue& edge, const PanelUnits& units, const Place& place);

/// Reads a closed loop of edges in the file's frame; empty after a defect, which names the edge.
/// [cm]
/// @param cubics   number of cubics in the panel's paths so far; this loop's are added
std::vector<Curve> readLoop(const JsonValue& json, const std::vector<Vec2>& vertices,
                            const PanelUnits& units, const Place& place, std::size_t* cubics);

/// Reads "free", "on", "across" or "bias".
GrainLock readGrainLock(const JsonValue& json, const Place& place);

/// Reads degrees between 0 and 90 and returns radians.
double readGrainTolerance(const JsonValue& json, const Place& place);

}  // namespace seamwise
