#pragma once
#include <Eigen/Core>
#include <vector>

#include "alignment/model/chamber.h"
#include "alignment/model/lattice_offset.h"
#include "alignment/model/matching.h"
#include "base/lanes.h"

namespace seamwise {

/// The seams of a MatchProblem as arrays for vector instructions. Samples are relative to the
/// pieces' centres. Print positions are in coordinates of the reduced lattice basis, where rounding
/// finds the nearest lattice vector. Single precision is twice as fast and exact to about 1e-5 cm;
/// its positions are those of the print's chamber, if the print has mirrors and all elements are
/// allowed.
///
/// Pieces at rest meet point by point, each with the nearest element there. Shapes follow one
/// element along a whole seam (Wolff et al. 2019, Eq. 4): under slack, the distance left by the
/// best join counts, in the sense of least squares.
/// @tparam Real   float or double
template <class Real>
class SampledSeams {
 public:
  /// @param spacing   least length of seam per sample, cm; 0: every edge is a sample
  SampledSeams(const MatchProblem& problem, double spacing);

  /// The maps of a leader from its centred coordinates to those of the lattice, modulo 1, and of
  /// the chamber. Without a chamber both maps are to the lattice.
  struct Pose {
    struct Map {
      Real m00, m01, m10, m11, t0, t1;
    };
    Map chamber, lattice;
    Real cos, sin;  ///< cosine and sine of the alignment's angle
  };
  /// The pose of a leader at an alignment.
  Pose pose(int leader, const Alignment& at) const;

  /// Cost of one seam: E = sum of w d, with d from each sample to the nearest equivalent point,
  /// plus SearchTuning::kBeyondLimit times the excess of E over the seam's limit. Under slack, at
  /// most the cost of shaping: the sum of w (max(0, r - slack) + kLeak r), with r through the best
  /// join, plus the same multiple of the excess that shaping is likely to leave. [cm2]
  /// @param slack   mismatch that shapes can take up; 0: none. [cm]
  double cost(int seam, const Pose& a, const Pose& b, double slack) const;

  /// Second-order model of one seam's cost in (turn, shift) of side a, then of side b. Turns are
  /// about the centres, shifts in print space. Each sample keeps its nearest element, or that of
  /// the join; weights 1/d turn squares into distances. Only the lower triangle of the Hessian is
  /// set.
  struct Model {
    Eigen::Matrix<double, 6, 6> hessian;
    Eigen::Matrix<double, 6, 1> gradient;
  };
  Model model(int seam, const Pose& a, const Pose& b, double slack) const;

  /// Number of samples of a seam.
  int count(int seam) const { return seams_[seam].count; }
  /// Work of cost() for one sample, in element distances.
  double sampleCost() const;
  /// Rank of a leader in an order that keeps neighbours close.
  int rank(int leader) const { return ranks_[leader]; }
  /// Sum of all weights. [cm]
  double weight() const { return weight_; }

 private:
  using Vector = typename Lanes<Real>::Vector;
  static constexpr int kLanes = Lanes<Real>::kCount, kSums = 22;
  struct Element {
    Real m00, m01, m10, m11, a0, a1;
    Real cos, sin, det;  ///< print space: A = (cos, -det sin; sin, det cos)
    bool swaps;  ///< rectangular lattices only: m00 = m11 = 0 if true, m01 = m10 = 0 if false
  };
  /// Elements one by one, and in groups of a few; copies of the last one fill up a group.
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
    double limit = 0;  ///< limit of the sum of w d. [cm2]
    Real weight = 0;   ///< sum of w. [cm]
    /// Weighted means of both sides' samples, the sums of w (a - mean_a) (b - mean_b)^T and of both
    /// sides' squared distances from their means.
    Real mean_ax = 0, mean_ay = 0, mean_bx = 0, mean_by = 0;
    Real axbx = 0, axby = 0, aybx = 0, ayby = 0, spread = 0;
  };
  /// Sums over a seam of w d, and of w times the excess of d over the slack. [cm2]
  struct Sums {
    double all, beyond;
  };
  /// x = A y + a for a whole seam, on the lattice.
  struct Through {
    Element element;
    bool within_reach;  ///< near enough to be shaped
  };
  /// The treatment of a seam in cost() and model().
  struct Choice {
    bool shaped;
    bool exceeds;  ///< exceeds its limit
    double cost;
    Through join;  ///< valid if the seam is within reach of shaping
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
  std::vector<Real> ax_, ay_, bx_, by_, w_;  ///< seams start at multiples of kLanes; w 0 in gaps
  std::vector<Vec2> centres_;
  std::vector<int> ranks_;
  Mat2 to_pose_;  ///< map from the print to the coordinates of poses, together with pose_offset_
  Vec2 pose_offset_ = Vec2::Zero();
  Mat2 to_lattice_;  ///< map from a chamber's coordinates to the lattice's, without offset
  Chamber::Shape shape_ = Chamber::Shape::kCell;  ///< shape of the chamber that contains the poses
  struct Coset {
    Real m00, m01, m10, m11, a0, a1;
  };
  std::vector<Coset> cosets_;  ///< cosets of the chamber, without the identity
  Real square0_ = 1, square1_ = 1;
  Real u0x_, u0y_, u1x_, u1y_;  ///< the reduced basis
  Real g11_, g12_, g22_;        ///< metric in reduced coordinates, 0 <= 2 g12 <= g11 <= g22
  bool rectangular_;            ///< g12 = 0
  double weight_ = 0;
};

extern template class SampledSeams<float>;
extern template class SampledSeams<double>;

/// Seams in single precision, for searches and bounds.
using SearchSamples = SampledSeams<float>;

}  // namespace seamwise
