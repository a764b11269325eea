#pragma once
#include <array>
#include <vector>

#include "alignment/bound/boxes.h"
#include "alignment/model/lattice_offset.h"

namespace seamwise {

/// What a seam costs at least when each of its two leaders lies somewhere in a box. It stands on
/// two facts. A distance modulo the group changes by no more than its two points move, so that d -
/// rho is a bound in boxes of centre distance d, and for all elements but the nearest a bound
/// M. And the distance to the nearest is convex in the shifts, so that it is at least what its
/// slope at the centre says, less what turns bend. That is a line, from low to high in the boxes;
/// the lesser of it and M is concave, and so its chord between those two is a bound. The mean of a
/// group of edges lies on the line that their mean points have, without loss.
class SeamBound {
 public:
  SeamBound(const MatchProblem& problem, const MatchSeam& seam);

  /// Bounds hold for all edges of the seam; up to rounding. [cm2]
  struct Pair {
    double least = 0;               ///< a bound
    double middle = 0;              ///< middle + slope . x is a bound at x in [-1, 1]^6
    std::array<double, 6> slope{};  ///< for turn and shifts of side a, then of side b
    double steepness() const;
  };
  /// @param reach_a, reach_b   as in Boxes
  /// @param spent              grows by the element distances evaluated
  Pair between(const Box& a, double reach_a, const Box& b, double reach_b, double& spent) const;

  const MatchSeam& seam() const { return *seam_; }

 private:
  using Real = float;
  using Vector = Lanes<Real>::Vector;
  static constexpr std::size_t kLanes = Lanes<Real>::kCount;
  /// Edges in groups that count with the means of both sides; a multiple of kLanes of them, the
  /// last without weight.
  struct Level {
    std::vector<Real> ax, ay, bx, by;  ///< means, from the leaders' centres
    std::vector<Real> far_a, far_b;    ///< greatest distances from there
    std::vector<Real> w;
    std::vector<Real> spread, radius;  ///< distance of both sides from the means: mean, greatest
    double mean_spread = 0;
  };
  /// An element that the seam allows, in coordinates of the reduced lattice basis and in print
  /// space, A = (cos, -det sin; sin, det cos).
  struct Image {
    const Element* element;
    Real m00, m01, m10, m11, a0, a1;
    Real cos, sin, det;
  };
  struct Pose {
    Real m00, m01, m10, m11, t0, t1;
    Real cos, sin;
  };
  Pose pose(int leader, const Alignment& at) const;
  struct Lines;
  Pair sumOfLines(const Lines& lines, const Box& a, const Box& b) const;
  double ownFlat(const Level& level, const Box& box) const;

  const MatchProblem& problem_;
  const MatchSeam* seam_;
  std::vector<Level> levels_;  ///< finest first
  std::vector<Image> images_;
  double rounding_;  ///< what single precision may add to a bound
  Mat2 to_reduced_;
  Real u0x_, u0y_, u1x_, u1y_;  ///< the reduced basis
  Real g11_, g12_, g22_;        ///< metric in reduced coordinates
};

}  // namespace seamwise
