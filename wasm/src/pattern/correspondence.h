#pragma once
#include <optional>
#include <vector>

#include "pattern/loop.h"

namespace seamwise {

/// Places of two loops that are images of each other under a mirror.
struct Correspondence {
  struct Anchor {
    double from, to;  ///< cm along the first and the second loop, not wrapped
    bool certain;  ///< two corners, or an axis crossing; else one is the foot of the other's image
  };
  /// `from` ascends and `to` descends, within one turn. For a loop that is symmetric in itself:
  /// from one axis crossing to the other, both included, so one half; the other half is the
  /// reverse.
  std::vector<Anchor> anchors;
  double tolerance = 0;  ///< corners closer than this were taken for images of each other. [cm]
};

/// Matches two loops under a mirrored motion: corners that meet within a tolerance, measured from
/// how well the outlines agree, become anchors; a corner without partner is anchored at the nearest
/// free point. Empty when the outlines lie further than `greatest` cm apart.
std::optional<Correspondence> correspond(const Loop& a, const Loop& b, const RigidMotion& map,
                                         double greatest);

/// The same for a loop that is symmetric in itself. Empty also when the axis does not cross it.
std::optional<Correspondence> correspondToItself(const Loop& a, const RigidMotion& map,
                                                 double greatest);

}  // namespace seamwise
