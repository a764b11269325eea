#include "alignment/model/grain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "alignment/model/admissible_alignments.h"
#include "alignment/model/symmetric.h"

namespace seamwise {
namespace {

constexpr double kSameAngle = 1e-6;  ///< rad

/// Least deviation of a piece from its wanted angles. [rad]
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

PieceRule withImage(const WallpaperGroup& group, const RigidMotion& map, const PieceRule& first,
                    const PieceRule& second) {
  if (first.pin || second.angles.empty()) return first;
  std::vector<double> sources;  // angles of `first` whose image has a wanted angle
  for (double angle : second.angles)
    for (const Element& e : group.elements())
      if (e.mirrored) sources.push_back(mirrorImage({angle, Vec2::Zero()}, map, e).angle);
  if (first.angles.empty()) return {{}, std::move(sources), second.tolerance};
  PieceRule both;
  double widest = -1;
  for (double angle : first.angles) {
    for (double source : sources) {
      // The overlap of the ranges about both angles, relative to `angle`.
      const double off = wrapAngle(source - angle);
      const double low = std::max(-first.tolerance, off - second.tolerance);
      const double high = std::min(first.tolerance, off + second.tolerance);
      const double half = std::max(0.0, (high - low) / 2);
      if (high < low - kSameAngle || half < widest - kSameAngle) continue;
      if (half > widest + kSameAngle) both.angles.clear(), widest = half;
      const bool whole = half > first.tolerance - kSameAngle;
      const double middle = whole ? angle : angle + (low + high) / 2;
      if (both.angles.empty() || offGrain(both.angles, {middle, Vec2::Zero()}) > kSameAngle)
        both.angles.push_back(middle);
    }
  }
  if (both.angles.empty()) return first;
  both.tolerance = widest;
  return both;
}

bool keepsGrain(const WallpaperGroup& group, const RigidMotion& map, const PieceRule& first,
                const PieceRule& second, bool single) {
  if (first.pin || second.pin || first.angles.empty() || second.angles.empty()) return true;
  if (single)
    return AdmissibleAlignments::mirrored(map, group).restrictAngles(first.angles, first.tolerance);
  const double tolerance = first.tolerance + second.tolerance + 1e-6;
  return std::any_of(first.angles.begin(), first.angles.end(), [&](double angle) {
    const Alignment on_grain{angle, Vec2::Zero()};
    return offGrain(second.angles, mirroredOnGrain(group, map, second.angles, on_grain)) <=
           tolerance;
  });
}

}  // namespace seamwise
