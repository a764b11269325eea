#pragma once
#include <vector>

#include "io/json_input.h"
#include "pattern/garment.h"

namespace seamwise {

/// Reads marked lines: [{"a": {"piece": "left_front", "line": [[x, y], ...]}, "b": {...}, "weight":
/// 1}], in input panel coordinates, cm. Both returned lines have the same number of points, evenly
/// spaced by arc length at most 1 cm apart, face side up. Defects: place.shape, place.number.
std::vector<MatchLine> readMatches(const JsonValue& json, const Place& place,
                                   const Garment& garment);

}  // namespace seamwise
