#pragma once
#include <vector>

#include "deform/terms.h"
#include "pattern/pattern.h"

namespace seamwise {

/// The deformation of Wolff et al. 2019, Eq. 8: one energy over all vertices of all pieces,
/// minimised by damped Newton steps with line search. Sewability and symmetry are quadratic
/// penalties whose weight gamma doubles from 1 until both hold.
class PenaltyDeformation {
 public:
  /// @param with_symmetry   false omits E_sym, as in the method that the paper extends
  PenaltyDeformation(const Pattern& pattern, bool with_symmetry);

  /// Restarts from rest towards ideal seam lines, or `share` of the way there.
  void start(std::vector<Target> targets, double alpha, double share = 1);
  /// Continues from the present shapes and gamma with another weight of the conformal term. The
  /// result may differ a little from that of a start from rest.
  void stiffen(double alpha);
  /// Takes one Newton step. Returns false once E_match and E_sym are below 1e-6 cm2 a vertex, both
  /// sides of every seam have the same length within 0.008 cm, and every vertex is within 0.0008 cm
  /// of its image. Also returns false if that is unattainable.
  bool step();
  int iterations() const { return iterations_; }
  double gamma() const { return gamma_; }
  /// Number of values of gamma solved so far.
  int gammas() const { return gammas_; }
  /// First coordinate block of a piece: vertex v of piece p is vertex first(p) + v of the terms.
  int first(int piece) const { return first_[piece]; }
  Shapes shapes() const;

 private:
  double energy(const VectorX& x, VectorX* gradient, SparseHessian* hessian) const;
  double greatestSeamError() const;
  double greatestMirrorError() const;
  Vec2 point(int piece, int vertex) const;

  const Pattern& pattern_;
  std::vector<int> first_;
  VectorX rest_, x_;
  std::vector<ConformalTriangle> triangles_;
  std::vector<EdgePair> edges_;
  std::vector<MirrorPair> mirrors_;
  std::vector<Target> targets_;
  SparseHessian hessian_;
  double alpha_ = 1, gamma_ = 1;
  int iterations_ = 0, at_this_gamma_ = 0, gammas_ = 0;
};

}  // namespace seamwise
