#pragma once
#include <optional>
#include <vector>

#include "pattern/loop.h"

namespace seamwise {

/// A one-to-one map between two loops that reverses their direction: piecewise linear in arc length
/// between anchors. It inverts exactly, so points carried to and fro do not drift, however
/// imperfect the symmetry of the drafted outlines.
struct Correspondence {
  struct Anchor {
    double from, to;  ///< cm along the first and the second loop, not wrapped
  };
  /// `from` ascends by the first loop's length in all, `to` descends by the second's.
  std::vector<Anchor> anchors;
  double tolerance = 0;  ///< corners closer than this were taken for images of each other. [cm]

  double image(double position) const;
  double preimage(double position) const;
};

/// Matches two loops under a mirrored motion: corners that meet within a tolerance, measured from
/// how well the outlines agree, become anchors; a corner without partner is anchored at the nearest
/// free point. Empty when the outlines lie further than `greatest` cm apart.
std::optional<Correspondence> correspond(const Loop& a, const Loop& b, const RigidMotion& map,
                                         double greatest);

/// The same for a loop that is symmetric in itself: an involution whose two fixed points are where
/// the axis crosses the loop. Empty also when the axis does not cross it.
std::optional<Correspondence> correspondToItself(const Loop& a, const RigidMotion& map,
                                                 double greatest);

}  // namespace seamwise
