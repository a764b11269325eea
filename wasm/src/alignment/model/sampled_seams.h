#pragma once
#include <Eigen/Core>
#include <vector>

#include "alignment/model/chamber.h"
#include "alignment/model/lattice_offset.h"
#include "alignment/model/matching.h"
#include "base/lanes.h"

namespace seamwise {

/// The seams of a MatchProblem as arrays for vector instructions: samples relative to the pieces'
/// centres, print positions in coordinates of the reduced lattice basis, where the nearest lattice
/// vector is found by rounding. In single precision twice as fast and exact to about 1e-5 cm; there
/// positions are those of the print's chamber, if it has mirrors and all elements are allowed.
///
/// Pieces at rest meet point by point, each with the element that is nearest there. Shapes follow
/// one element all along a seam (Wolff et al. 2019, Eq. 4): under slack, what counts is the
/// distance left by the join that is best in the sense of least squares.
/// @tparam Real   float or double
template <class Real>
class SampledSeams {
 public:
  /// @param spacing   cm of seam a sample stands for, at least; 0: every edge is a sample
  SampledSeams(const MatchProblem& problem, double spacing);

  /// Where a leader lies: from its centred coordinates to those of the lattice, modulo 1, and to
  /// those of the chamber or, where there is none, once more of the lattice.
  struct Pose {
    struct Map {
      Real m00, m01, m10, m11, t0, t1;
    };
    Map chamber, lattice;
    Real cos, sin;  ///< of the alignment's angle
  };
  /// The pose of a leader that lies at `at`.
  Pose pose(int leader, const Alignment& at) const;

  /// Cost of one seam: E = sum of w d, d from each sample to the nearest equivalent point, and
  /// SearchTuning::kBeyondLimit times what E exceeds the seam's limit by. Under slack, at most the
  /// cost of shaping: the sum of w (max(0, r - slack) + kLeak r), r through the best join, and so
  /// many times what shaping is likely to leave beyond the limit. [cm2]
  /// @param slack   mismatch that shapes can take up; 0: none. [cm]
  double cost(int seam, const Pose& a, const Pose& b, double slack) const;

  /// Second-order model of one seam's cost in (turn, shift) of side a, then of side b, about the
  /// centres, shifts in print space: each sample keeps its nearest element, or that of the join,
  /// weights 1/d make squares of distances. Only the lower triangle of the Hessian is set.
  struct Model {
    Eigen::Matrix<double, 6, 6> hessian;
    Eigen::Matrix<double, 6, 1> gradient;
  };
  Model model(int seam, const Pose& a, const Pose& b, double slack) const;

  /// Number of samples of a seam.
  int count(int seam) const { return seams_[seam].count; }
  /// Work of cost() for one sample, in element distances.
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
  /// Elements one by one, and a few at once; the last stands for those that are missing.
  struct Elements {
    struct Few {
      Vector m00, m01, m10, m11, a0, a1, cos, sin, det;
    };
    std::vector<Element> each;
    std::vector<Few> few;
    void pack();
  };
  struct Samples {
    int count = 0, from = 0;
    const Elements* elements = nullptr;
    double limit = 0;  ///< of the sum of w d. [cm2]
    Real weight = 0;   ///< sum of w. [cm]
    /// Weighted means of both sides' samples, the sums of w (a - mean_a) (b - mean_b)^T and of both
    /// sides' squared distances from their means.
    Real mean_ax = 0, mean_ay = 0, mean_bx = 0, mean_by = 0;
    Real axbx = 0, axby = 0, aybx = 0, ayby = 0, spread = 0;
  };
  /// Sums over a seam of w d, and of what d exceeds the slack by. [cm2]
  struct Sums {
    double all, beyond;
  };
  /// x = A y + a for a whole seam, on the lattice.
  struct Through {
    Element element;
    bool within_reach;  ///< near enough to be shaped
  };
  /// What cost() and model() take a seam for.
  struct Choice {
    bool shaped;
    bool exceeds;  ///< its limit
    double cost;
    Through join;  ///< if it may be shaped
  };
  void measure(Samples& samples) const;
  Choice chosen(int seam, const Pose& a, const Pose& b, double slack) const;
  Through through(const Samples& of, const Pose& a, const Pose& b, double slack) const;
  Sums sumsThrough(const Element& join, const Samples& of, const Pose& a, const Pose& b,
                   double slack) const;
  double sum(int seam, const Pose& a, const Pose& b) const;
  struct Placed;
  using Offset = LatticeOffset<Real>;
  Placed placed(int from, const typename Pose::Map& a, const typename Pose::Map& b) const;
  Offset reduced(const Vector& s0, const Vector& t0) const;
  Offset offset(const Placed& p, const Element& e) const;
  Vector squaredOnRectangles(const Placed& p, const Element& e) const;
  template <class Squared>
  double sumOver(int seam, const Pose& a, const Pose& b, const Squared& squared) const;
  template <bool triangle>
  double foldedSum(int seam, const Pose& a, const Pose& b) const;
  template <bool triangle>
  Vector squaredInChamber(const Placed& p) const;

  Elements all_, proper_, improper_;
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

/// Seams in single precision, as searches and bounds use them.
using SearchSamples = SampledSeams<float>;

}  // namespace seamwise
