#pragma once
#include <string>
#include <vector>

#include "io/json_input.h"
#include "pattern/garment.h"

namespace seamwise {

/// How a garment file writes lengths and control points.
struct PanelUnits {
  double cm = 1;  ///< centimetres per unit of the file
  bool absolute_controls =
      false;  ///< control points in panel coordinates, else relative to the edge
};

/// The panel, face side up and in centimetres; of no use after a defect. `place` names it.
Panel readPanel(const std::string& name, const JsonValue& json, const PanelUnits& units,
                const Place& place);

}  // namespace seamwise
