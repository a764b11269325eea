#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// Sign of the area of triangle a, b, c: +1 counter-clockwise, -1 clockwise, 0 exactly collinear.
/// Exact for all doubles whose products neither overflow nor underflow [Shewchuk 1997].
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Returns whether d is certainly inside the circle through the counter-clockwise triangle a, b, c.
/// Returns false where rounding leaves a doubt, so flips that rely on it always terminate.
bool insideCircle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

}  // namespace seamwise
