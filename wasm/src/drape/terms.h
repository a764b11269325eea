#pragma once
#include <vector>

#include "drape/block_matrix.h"
#include "drape/distance.h"
#include "drape/fabric.h"
#include "drape/sewn_mesh.h"
#include "numeric/sparse.h"

namespace seamwise {

/// Energy terms of a worn garment, each a function of the positions of the cloth's vertices. SI:
/// positions in m, energies in J. Each function returns its value and adds its gradient and a
/// positive semidefinite Hessian unless the pointers are null.

/// Stretch and shear of triangles: A/2 (ku eu^2 + kv ev^2 + 2 kuv eu ev + ks (wu . wv)^2) with eu =
/// |wu| - 1 and the images wu and wv of weft and warp. The stiffness is higher beyond
/// Fabric::stiff_from. The conditions are those of Baraff, Witkin, "Large Steps in Cloth
/// Simulation", 1998.
/// The Hessian omits the coupling kuv, treats shear as Gauss-Newton does, and drops terms that
/// compression makes negative. Gathered triangles have a five-hundredth of the resistance to
/// compression along the gathers and no coupling.
double membraneEnergy(const SewnMesh& mesh, const Fabric& fabric, const Positions& x,
                      Positions* gradient, BlockMatrix* hessian);

/// Factor that makes strips of irregular triangles sag like plates of bending stiffness B, within 5
/// %. The exact factor is 1 for a sheet of equilateral triangles bent to a cylinder: each hinge
/// takes the bend of two triangles' width, and three hinges share it. Irregular triangles yield
/// between hinges. A strip of denim, 6 cm long, sags by 41 % less than it should with the customary
/// factor 3.
inline constexpr double kHinge = 1.25;

/// Bending energy: kHinge B/2 |sum of weights x|^2 / (A0 + A1) per hinge, quadratic. On a pressed
/// fold, |sum of weights x| - Hinge::folded takes the place of |sum of weights x|.
double bendingEnergy(const SewnMesh& mesh, const Fabric& fabric, const Positions& x,
                     Positions* gradient, BlockMatrix* hessian);

/// Gravity: weight times height, linear.
double gravityEnergy(const SewnMesh& mesh, const Fabric& fabric, const Positions& x,
                     Positions* gradient);

/// Distance from a body, m. The middle of a triangle is outside the body if all its corners are
/// further away than this.
inline constexpr double kNearBody = 0.02;

/// Contact that keeps cloth off a body: k/2 A max(0, offset - d)^2 per vertex. The same applies
/// with half the offset to the middles of triangles, which cut curves of the body short.
struct BodyContact {
  const DistanceField* body = nullptr;
  double offset = 0;     ///< m
  double stiffness = 0;  ///< N/m3
  /// Per vertex: whether it or its triangles can reach the body; empty: all can.
  std::vector<char> near = {};
};
/// Contact energy. The Hessian omits the second derivative of the distance.
double contactEnergy(const SewnMesh& mesh, const BodyContact& contact, const Positions& x,
                     Positions* gradient, BlockMatrix* hessian);

/// Vertex that a body holds by friction, in its state at the start of the step.
struct Friction {
  int vertex;
  double limit;  ///< friction coefficient times the normal force, N
  Vec3 normal;   ///< unit
  Vec3 anchor;   ///< point where the vertex sticks
};
/// Friction energy: limit f(|u|) with u the part of x - anchor along the body, f(s) = s beyond
/// `threshold` m and smooth below it (Li et al., "Incremental Potential Contact", 2020).
double frictionEnergy(const std::vector<Friction>& contacts, double threshold, const Positions& x,
                      Positions* gradient, BlockMatrix* hessian);

/// Proximal term that shortens steps: m/2 |x - from|^2 / h^2, h in s.
double proximalEnergy(const SewnMesh& mesh, const Fabric& fabric, double h, const Positions& from,
                      const Positions& x, Positions* gradient, BlockMatrix* hessian);

/// Adds a constant substitute for the membrane's Hessian to a preconditioner: one number for the
/// ends of each edge, the same for all three coordinates and all positions (Bouaziz et al.,
/// "Projective Dynamics", 2014). It omits bending, which is a ten-thousandth of the membrane's part
/// and doubles the fill.
void addConstantHessian(const SewnMesh& mesh, const Fabric& fabric, SparseHessian& matrix);

}  // namespace seamwise
