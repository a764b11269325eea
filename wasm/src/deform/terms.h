#pragma once
#include <array>
#include <vector>

#include "numeric/sparse.h"

namespace seamwise {

/// The terms of the deformation energy of Wolff et al. 2019, Eq. 8, each a pure function of the
/// coordinates x = (x0, y0, x1, y1, ...) in cm. Each returns its value and adds, where the pointers
/// are not null, its gradient and a positive semidefinite Hessian (exact for the quadratic terms,
/// Gauss-Newton for the others).

struct Target {
  int vertex;
  Vec2 position;
  double weight;  ///< seam weight x cm of seam
};
/// E_prox = sum w |b - b*|^2
double proximityEnergy(const std::vector<Target>& targets, const VectorX& x, VectorX* gradient,
                       SparseHessian* hessian);

/// A triangle's rest state: rows of the linear map from its 6 coordinates to (u_x - v_y, u_y +
/// v_x).
struct ConformalTriangle {
  std::array<int, 3> vertices;
  double area;  ///< at rest, cm2
  std::array<std::array<double, 6>, 2> rows;
};
ConformalTriangle conformalTriangle(const std::array<int, 3>& vertices, const Vec2& a,
                                    const Vec2& b, const Vec2& c);
/// E_conf = sum A |J - cof J|^2 / 2, J the Jacobian of rest -> shape (Levy et al. 2002)
double conformalEnergy(const std::vector<ConformalTriangle>& triangles, const VectorX& x,
                       double weight, VectorX* gradient, SparseHessian* hessian);

/// E_flip = sum A phi(d / s), d = area / rest area, phi(t) = 1 / (t^3 - 3 t^2 + 3 t) - 1 for 0 < t
/// < 1, 0 above, infinite below, s = PaperTuning::kFlipStart (Schueller et al. 2013).
double flipEnergy(const std::vector<ConformalTriangle>& triangles, const VectorX& x, double weight,
                  VectorX* gradient, SparseHessian* hessian);

/// Two sewn edges (a0 a1), (b0 b1) whose lengths keep the ratio rho.
struct EdgePair {
  int a0, a1, b0, b1;
  double rho;
};
/// E_match = sum (l_a - rho l_b)^2
double matchEnergy(const std::vector<EdgePair>& pairs, const VectorX& x, double weight,
                   VectorX* gradient, SparseHessian* hessian);

/// Vertex `image` should be Q x_source + shift.
struct MirrorPair {
  int source, image;
  Mat2 linear;
  Vec2 shift;
};
/// E_sym = sum |b' - (Q b + t)|^2; the map runs from b to b' as in Eq. 3 of the paper
double symmetryEnergy(const std::vector<MirrorPair>& pairs, const VectorX& x, double weight,
                      VectorX* gradient, SparseHessian* hessian);

}  // namespace seamwise
