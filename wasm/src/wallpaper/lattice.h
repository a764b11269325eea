#pragma once
#include <array>

#include "base/outcome.h"
#include "geometry/vec2.h"
#include "wallpaper/group.h"

namespace seamwise {

/// Checks w1, w2 [cm] against the lattice type of `group` and removes deviations below 1e-6
/// (relative), so that the group's elements are exact rigid motions. Errors: kLattice, one sentence
/// with the given lattice, the requirement and a remedy.
Outcome<std::array<Vec2, 2>> checkedLattice(const GroupData& group, const Vec2& w1, const Vec2& w2);

/// A shortest basis of the lattice (Lagrange): |r1| <= |r2|, at 60 to 90 degrees, left- or
/// right-handed. For parallel vectors, r1 is zero up to rounding, and exactly 0 in whole numbers.
std::array<Vec2, 2> lagrangeReduced(const Vec2& w1, const Vec2& w2);

}  // namespace seamwise
