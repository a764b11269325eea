#include "alignment/grain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment/freedom.h"
#include "alignment/symmetric.h"

namespace seamwise {
namespace {

/// How far a piece lies from the nearest of its wanted angles. [rad]
double offGrain(const std::vector<double>& angles, const Alignment& at) {
  if (angles.empty()) return 0;
  double least = std::numeric_limits<double>::max();
  for (double angle : angles) least = std::min(least, std::abs(wrapAngle(at.angle - angle)));
  return least;
}

}  // namespace

Alignment mirroredOnGrain(const WallpaperGroup& group, const RigidMotion& map,
                          const std::vector<double>& angles, const Alignment& first) {
  Alignment best;
  double least = std::numeric_limits<double>::infinity();
  for (const Element& e : group.elements()) {
    if (!e.mirrored) continue;
    const Alignment image = mirrorImage(first, map, e);
    const double off = offGrain(angles, image);
    if (off < least - 1e-9) least = off, best = image;
  }
  return best;
}

bool keepsGrain(const WallpaperGroup& group, const RigidMotion& map, const PieceRule& first,
                const PieceRule& second, bool single) {
  if (first.pin || second.pin || first.angles.empty() || second.angles.empty()) return true;
  if (single) return Freedom::mirrored(map, group).restrictAngles(first.angles, first.tolerance);
  const double room = first.tolerance + second.tolerance + 1e-6;
  return std::any_of(first.angles.begin(), first.angles.end(), [&](double angle) {
    const Alignment on_grain{angle, Vec2::Zero()};
    return offGrain(second.angles, mirroredOnGrain(group, map, second.angles, on_grain)) <= room;
  });
}

}  // namespace seamwise
