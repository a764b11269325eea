#pragma once
#include <vector>

#include "drape/block_matrix.h"
#include "drape/distance.h"
#include "drape/fabric.h"
#include "drape/sewn_mesh.h"
#include "numeric/sparse.h"

namespace seamwise {

/// The terms of a worn garment's energy, each a function of the positions of the cloth's vertices.
/// SI: positions in m, energy in J. Each returns its value and adds, where the pointers are not
/// null, its gradient and a positive semidefinite Hessian.

/// Stretch and shear of triangles: A/2 (ku eu^2 + kv ev^2 + 2 kuv eu ev + ks (wu . wv)^2), eu =
/// |wu| - 1, wu and wv the images of weft and warp, and so much more beyond Fabric::stiff_from (the
/// conditions of Baraff, Witkin, "Large Steps in Cloth Simulation", 1998). The Hessian leaves out
/// the coupling kuv, takes shear as Gauss-Newton does, and drops what compression makes negative.
/// Gathered triangles resist compression along the gathers a five hundredth as much and have no
/// coupling.
double membraneEnergy(const SewnMesh& mesh, const Fabric& fabric, const Positions& x,
                      Positions* gradient, BlockMatrix* hessian);

/// Makes strips of irregular triangles sag as plates of bending stiffness B, within 5 %. On a sheet
/// of equilateral triangles that is bent to a cylinder, 1 would be exact: each hinge takes the bend
/// of two triangles' width, and three hinges share them. Irregular ones give way between hinges.
/// With the customary 3 a strip of denim, 6 cm long, sags by 41 % less than it should.
inline constexpr double kHinge = 1.25;

/// Bending: kHinge B/2 |sum of weights x|^2 / (A0 + A1) per hinge, quadratic.
double bendingEnergy(const SewnMesh& mesh, const Fabric& fabric, const Positions& x,
                     Positions* gradient, BlockMatrix* hessian);

/// Weight times height; linear.
double gravityEnergy(const SewnMesh& mesh, const Fabric& fabric, const Positions& x,
                     Positions* gradient);

/// m from a body; where all corners of a triangle are further away, its middle is not inside.
inline constexpr double kNearBody = 0.02;

/// What holds cloth off a body: k/2 A max(0, offset - d)^2 per vertex, and the same with half the
/// offset for the middles of triangles, which cut curves of the body short.
struct BodyContact {
  const DistanceField* body = nullptr;
  double offset = 0;     ///< m
  double stiffness = 0;  ///< N/m3
  /// Per vertex, whether it may come near enough for it or its triangles to touch; empty: all may.
  std::vector<char> near = {};
};
/// The Hessian leaves out that of the distance.
double contactEnergy(const SewnMesh& mesh, const BodyContact& contact, const Positions& x,
                     Positions* gradient, BlockMatrix* hessian);

/// A vertex that a body holds by friction: as it was when the step began.
struct Friction {
  int vertex;
  double limit;  ///< friction coefficient times the normal force, N
  Vec3 normal;   ///< unit
  Vec3 anchor;   ///< where the vertex sticks
};
/// limit f(|u|), u the part of x - anchor along the body, f(s) = s beyond `threshold` m and smooth
/// below it (Li et al., "Incremental Potential Contact", 2020).
double frictionEnergy(const std::vector<Friction>& contacts, double threshold, const Positions& x,
                      Positions* gradient, BlockMatrix* hessian);

/// What keeps a step short: m/2 |x - from|^2 / h^2, h in s.
double proximalEnergy(const SewnMesh& mesh, const Fabric& fabric, double h, const Positions& from,
                      const Positions& x, Positions* gradient, BlockMatrix* hessian);

/// Adds what stands for the Hessian of the membrane in a preconditioner: one number for the ends of
/// each edge, the same for all three coordinates and all positions (Bouaziz et al.,
/// "Projective Dynamics", 2014). Without bending, a ten-thousandth of it, which doubles the fill.
void addConstantHessian(const SewnMesh& mesh, const Fabric& fabric, SparseHessian& matrix);

}  // namespace seamwise
