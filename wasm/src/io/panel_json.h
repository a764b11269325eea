#pragma once
#include <string>
#include <vector>

#include "io/json_input.h"
#include "pattern/garment.h"

namespace seamwise {

/// The form of lengths and control points in a garment file.
struct PanelUnits {
  double cm = 1;  ///< centimetres per unit of the file
  bool absolute_controls =
      false;  ///< control points in panel coordinates; false: relative to the edge
};

/// Reads a panel, face side up and in centimetres. The returned value is unusable after a defect.
/// @param place   the panel
Panel readPanel(const std::string& name, const JsonValue& json, const PanelUnits& units,
                const Place& place);

}  // namespace seamwise
