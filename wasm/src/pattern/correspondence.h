#pragma once
#include <optional>
#include <vector>

#include "pattern/loop.h"

namespace seamwise {

/// Positions of two loops that are images of each other under a mirror.
struct Correspondence {
  struct Anchor {
    double from, to;  ///< cm along the first and the second loop, not wrapped
    bool certain;     ///< two corners, or an axis crossing; false: one is the point nearest to the
                      ///< other's image
  };
  /// `from` ascends and `to` descends, within one turn. For a loop that is symmetric in itself, the
  /// anchors cover the half from one axis crossing to the other, both included; the other half is
  /// the reverse.
  std::vector<Anchor> anchors;
  double tolerance = 0;  ///< closer corners count as images of each other. [cm]
};

/// Matches two loops under a mirrored motion. Corners that meet within a tolerance, which depends
/// on the deviation of the outlines, become anchors. A corner without a partner is anchored at the
/// nearest free point. Empty if the outlines are more than `greatest` cm apart.
std::optional<Correspondence> correspond(const Loop& a, const Loop& b, const RigidMotion& map,
                                         double greatest);

/// The same for a loop that is symmetric in itself. Empty also if the axis does not cross it.
std::optional<Correspondence> correspondToItself(const Loop& a, const RigidMotion& map,
                                                 double greatest);

}  // namespace seamwise
