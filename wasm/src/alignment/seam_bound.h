#pragma once
#include <array>
#include <vector>

#include "alignment/boxes.h"

namespace seamwise {

/// What a seam costs at least when each of its two leaders lies somewhere in a box. It stands on
/// two facts. A distance modulo the group changes by no more than its two points move, so that d -
/// rho is a bound in boxes of centre distance d; and as long as one element is nearest, the
/// distance is convex in the shifts, so that it is at least what its slope at the centre says, less
/// what turns bend. Where another element comes near, a share of the slope is below both.
class SeamBound {
 public:
  SeamBound(const MatchProblem& problem, const MatchSeam& seam);

  /// A bound holds for all edges of the seam; up to rounding. [cm2]
  struct Pair {
    double cost = 0;                ///< at the centres, about
    double flat = 0;                ///< a bound
    double middle = 0;              ///< middle + slope . x is a bound at x in [-1, 1]^6
    std::array<double, 6> slope{};  ///< for turn and shifts of side a, then of side b
    double steepness() const;
    double bound() const { return std::max(flat, middle - steepness()); }
  };
  /// @param reach_a, reach_b   as in Boxes
  /// @param spent              grows by the element distances evaluated
  Pair between(const Box& a, double reach_a, const Box& b, double reach_b, double& spent) const;

  const MatchSeam& seam() const { return *seam_; }

 private:
  /// A few edges that lie together: one stands for all, which are `radius` away in the mean.
  struct Sample {
    Vec2 a, b;  ///< from the leaders' centres
    double w, radius;
  };
  struct Level {
    std::vector<Sample> samples;
    double radius = 0;  ///< mean
  };
  /// An element that the seam allows, in coordinates of the reduced lattice basis.
  struct Image {
    const Element* element;
    double m00, m01, m10, m11, a0, a1;
  };
  /// Where one side of a sample may be nearest to an image of the other.
  struct Nearest {
    const Element* element = nullptr;
    double first = 0, second = 0;  ///< squares of the least distance and of the next
  };
  Nearest nearest(const Vec2& x, const Vec2& y) const;

  const MatchProblem& problem_;
  const MatchSeam* seam_;
  std::vector<Level> levels_;  ///< finest first
  std::vector<Image> images_;
  Mat2 to_reduced_;
  double g11_, g12_, g22_;  ///< metric in reduced coordinates
};

}  // namespace seamwise
