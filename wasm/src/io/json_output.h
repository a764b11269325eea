#pragma once
#include <nlohmann/json.hpp>

#include "geometry/vec2.h"

namespace seamwise {

/// What several files write alike.

inline nlohmann::ordered_json pointJson(const Vec2& p) {
  return nlohmann::ordered_json::array({p.x(), p.y()});
}

/// An alignment, or the map of a symmetry. [rad, cm]
inline nlohmann::ordered_json motionJson(double angle, const Vec2& translation) {
  return {{"angle", angle}, {"translation", pointJson(translation)}};
}

}  // namespace seamwise
