#pragma once
#include <array>
#include <vector>

#include "alignment/bound/boxes.h"
#include "alignment/model/lattice_offset.h"

namespace seamwise {

/// A lower bound of a seam's cost for all alignments of its two leaders in one box each. It follows
/// from two facts. First, a distance modulo the group changes by no more than its two points move:
/// d - rho is a bound in boxes of centre distance d, and for all elements but the nearest a bound
/// M. Second, the distance to the nearest element is convex in the shifts: it is at least its
/// tangent at the centre, minus the bending by turns. This tangent is a line, from low to high in
/// the boxes. The lesser of it and M is concave, so its chord between those two is a bound. The
/// mean of a group of edges is on the line of their mean points, without loss.
class SeamBound {
 public:
  SeamBound(const MatchProblem& problem, const MatchSeam& seam);

  /// Bounds for all edges of the seam, up to rounding. [cm2]
  struct Pair {
    double least = 0;               ///< a bound
    double middle = 0;              ///< middle + slope . x is a bound at x in [-1, 1]^6
    std::array<double, 6> slope{};  ///< for turn and shifts of side a, then of side b
    double steepness() const;
  };
  /// @param reach_a, reach_b   see Boxes::reach
  /// @param spent              grows by the number of element distances evaluated
  Pair between(const Box& a, double reach_a, const Box& b, double reach_b, double& spent) const;

  const MatchSeam& seam() const { return *seam_; }

 private:
  using Real = float;
  using Vector = Lanes<Real>::Vector;
  static constexpr std::size_t kLanes = Lanes<Real>::kCount;
  /// Groups of edges, represented by the means of both sides. Their number is a multiple of kLanes;
  /// the last ones have no weight.
  struct Level {
    std::vector<Real> ax, ay, bx, by;  ///< means, relative to the leaders' centres
    std::vector<Real> far_a, far_b;    ///< greatest distances from the centres
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
  double rounding_;  ///< greatest error of a bound in single precision
  Mat2 to_reduced_;
  Real u0x_, u0y_, u1x_, u1y_;  ///< the reduced basis
  Real g11_, g12_, g22_;        ///< metric in reduced coordinates
};

}  // namespace seamwise
