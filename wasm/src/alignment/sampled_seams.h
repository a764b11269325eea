#pragma once
#include <Eigen/Core>
#include <vector>

#include "alignment/chamber.h"
#include "alignment/lattice_offset.h"
#include "alignment/matching.h"
#include "geometry/lanes.h"

namespace seamwise {

/// The seams of a MatchProblem as arrays that a vector unit likes: samples relative to the pieces'
/// centres, print positions in coordinates of the reduced lattice basis, where the nearest lattice
/// vector is found by rounding. In single precision twice as fast and exact to about 1e-5 cm; there
/// positions are those of the print's chamber, if it has mirrors and all elements are allowed.
/// @tparam Real   float or double
template <class Real>
class SampledSeams {
 public:
  /// @param spacing   cm of seam a sample stands for, at least; 0: every edge is a sample
  SampledSeams(const MatchProblem& problem, double spacing);

  /// Where a leader lies: from its centred coordinates to those of lattice or chamber, modulo 1.
  struct Pose {
    Real m00, m01, m10, m11, t0, t1;
    double cos, sin;  ///< of the alignment's angle
  };
  Pose pose(int leader, const Alignment& at) const;

  /// Sum of w (max(0, d - slack) + leak d) over one seam, of w d without slack; several times as
  /// much of what a seam misses by beyond its limit, if it has one. [cm2]
  double cost(int seam, const Pose& a, const Pose& b, double slack) const;

  /// Second-order model of one seam's cost in (turn, shift) of side a, then of side b, about the
  /// centres, shifts in print space: each sample keeps its nearest element, weights 1/d make
  /// squares of distances. Only the lower triangle of the Hessian is set.
  struct Model {
    Eigen::Matrix<double, 6, 6> hessian;
    Eigen::Matrix<double, 6, 1> gradient;
  };
  Model model(int seam, const Pose& a, const Pose& b, double slack) const;

  /// Number of samples of a seam.
  int count(int seam) const { return seams_[seam].count; }
  /// What cost() takes for a sample, in element distances.
  double sampleCost() const;
  /// Place of a leader in an order in which neighbours follow closely.
  int rank(int leader) const { return ranks_[leader]; }
  /// Sum of all weights. [cm]
  double weight() const { return weight_; }

 private:
  using Vector = typename Lanes<Real>::Vector;
  static constexpr int kLanes = Lanes<Real>::kCount, kSums = 22;
  struct Element {
    Real m00, m01, m10, m11, a0, a1;
    Real cos, sin, det;  ///< in print space A = (cos, -det sin; sin, det cos)
    bool swaps;          ///< of a rectangular lattice: m00 = m11 = 0; otherwise m01 = m10 = 0
  };
  struct Samples {
    int count = 0, from = 0;
    const std::vector<Element>* elements = nullptr;
    double limit = 0;  ///< of the sum of w d. [cm2]
  };
  /// Sums over a seam of w d, and of what d exceeds the slack by. [cm2]
  struct Sums {
    double all, beyond;
  };
  Sums sums(int seam, const Pose& a, const Pose& b, double slack) const;
  /// Whether the sums break the seam's limit, and how: while it is beyond what shaping mends.
  enum class Excess : std::uint8_t { kNone, kOfAll, kOfBeyond };
  Excess excess(int seam, const Sums& of, double slack) const;
  struct Placed;
  using Offset = LatticeOffset<Real>;
  Placed placed(int from, const Pose& a, const Pose& b) const;
  Pose onLattice(const Pose& pose) const;
  Offset reduced(const Vector& s0, const Vector& t0) const;
  Offset offset(const Placed& p, const Element& e) const;
  Vector squaredOnRectangles(const Placed& p, const Element& e) const;
  template <class Squared>
  Sums sumsOver(int seam, const Pose& a, const Pose& b, double slack, const Squared& squared) const;
  template <bool triangle>
  Sums foldedSums(int seam, const Pose& a, const Pose& b, double slack) const;
  template <bool triangle>
  Vector squaredInChamber(const Placed& p) const;

  std::vector<Element> all_, proper_, improper_;
  std::vector<Samples> seams_;
  std::vector<Real> ax_, ay_, bx_, by_, w_;  ///< each seam from a multiple of kLanes; w 0 in gaps
  std::vector<Vec2> centres_;
  std::vector<int> ranks_;
  Mat2 to_pose_;  ///< from the print to the coordinates of poses, with
  Vec2 pose_offset_ = Vec2::Zero();
  Mat2 to_lattice_;  ///< from those of a chamber to the lattice's, with no offset
  Chamber::Shape shape_ = Chamber::Shape::kCell;  ///< of what poses lie in
  struct Coset {
    Real m00, m01, m10, m11, a0, a1;
  };
  std::vector<Coset> cosets_;  ///< of the chamber; the identity is left out
  Real square0_ = 1, square1_ = 1;
  Real u0x_, u0y_, u1x_, u1y_;  ///< the reduced basis
  Real g11_, g12_, g22_;        ///< metric in reduced coordinates, 0 <= 2 g12 <= g11 <= g22
  bool rectangular_;            ///< g12 = 0
  double weight_ = 0;
};

extern template class SampledSeams<float>;
extern template class SampledSeams<double>;

}  // namespace seamwise
