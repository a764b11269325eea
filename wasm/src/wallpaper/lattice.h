#pragma once
#include <array>

#include "base/outcome.h"
#include "geometry/vec2.h"
#include "wallpaper/group.h"

namespace seamwise {

/// Checks w1, w2 [cm] against what `group` needs and removes deviations below 1e-6 (relative), so
/// that the group's elements are exact rigid motions. Errors: kLattice, one sentence that says what
/// is given, what is needed and how to get there.
Outcome<std::array<Vec2, 2>> checkedLattice(const GroupData& group, const Vec2& w1, const Vec2& w2);

/// A shortest basis of the lattice (Lagrange): |r1| <= |r2|, at 60 to 90 degrees, of either hand.
/// Of parallel vectors r1 is as short as rounding makes it, 0 in whole numbers.
std::array<Vec2, 2> lagrangeReduced(const Vec2& w1, const Vec2& w2);

}  // namespace seamwise
