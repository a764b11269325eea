#pragma once
#include <optional>
#include <vector>

#include "drape/contacts.h"
#include "drape/terms.h"

namespace seamwise {

/// What makes a cloth on a body move and stop.
struct ClothOptions {
  double contact_stiffness = 1.8e6;  ///< N/m3; a tight waistband sinks in by 1 mm
  double friction_threshold = 1e-3;  ///< m, within which friction is elastic
  bool friction = true;
  double first_step = 0.05, longest_step = 0.3;    ///< s, of the proximal term
  double farthest = 0.02, farthest_near = 0.01;    ///< m a vertex may move in one step; near a body
  double near = 0.03;                              ///< m from it: no vertex can pass a wrist
  double accuracy = 0.05;                          ///< of a Newton step, over its first residual
  int least_iterations = 1, most_iterations = 40;  ///< of conjugate gradients in a step
  std::vector<char> held;                          ///< per vertex, does not move; empty: none
  /// Per vertex the least x that it may have or, below 0, the greatest, m; 0: it may have any;
  /// kInPlane: stays at x = 0. Empty: no vertex is bound.
  std::vector<double> least_x;
  static constexpr double kInPlane = 1e9;
};

/// A cloth on its way to rest on a body. Each step lowers its energy: a Newton step by conjugate
/// gradients, preconditioned by one scalar matrix for all coordinates that is factorised beforehand
/// (the constant one of projective dynamics), or a quasi-Newton step from that matrix alone (Liu,
/// Bouaziz, Kavan, "Quasi-Newton Methods for Real-Time Simulation of Hyperelastic Materials",
/// 2017). Keeps pointers to mesh, fabric, body and contacts.
class ClothSolver {
 public:
  struct Step {
    double energy = 0;    ///< after it, J, without friction
    double fall = 0;      ///< of the energy that the step lowered, J
    double farthest = 0;  ///< m that a vertex moved
    int iterations = 0;   ///< of conjugate gradients
    bool failed = false;  ///< nothing moved: no shorter step lowers the energy, either
  };

  ClothSolver(const SewnMesh& mesh, const Fabric& fabric, const DistanceField& body,
              Positions start, ClothOptions options = {}, ClothContacts* contacts = nullptr);

  Step newtonStep();
  Step quasiNewtonStep();

  const Positions& positions() const { return x_; }
  /// Membrane, bending, weight and contact. [J]
  double energy() const;
  /// What it takes to lift the cloth by a metre: what energies are small or large against. [J]
  double weight() const;
  void setFriction(bool on);
  /// Whether its weight pulls on it; energies have it anyway.
  void setWeight(bool on) { weighs_ = on; }
  /// Spent so far, in factorisations of the matrix of a grid of 90 x 90 nodes with 2 unknowns each.
  double work() const { return operations_ / kOperationsPerUnit; }

 private:
  /// Multiplications in the time of one factorisation of the grid; measured (drape_cost).
  static constexpr double kOperationsPerUnit = 9e7;
  struct Pair {
    Positions moved, turned;  ///< of positions and gradient
    double product;
  };

  double planeEnergy(const Positions& x, Positions* gradient, BlockMatrix* hessian) const;
  double merit(const Positions& x, Positions* gradient, BlockMatrix* hessian);
  void lookAround();
  bool prepare();
  void precondition(Positions& r);
  void mask(Positions& r) const;
  Positions conjugateGradients(const Positions& gradient, int* iterations);
  Step search(double before, const Positions& gradient, const Positions& direction);
  void dragAnchors();

  const SewnMesh* mesh_;
  const Fabric* fabric_;
  BodyContact contact_;
  ClothOptions options_;
  ClothContacts* contacts_;
  Positions x_;
  Positions from_;  ///< where the step began
  bool weighs_ = true;
  double h_;  ///< s, of the proximal term; 0: none
  double factorised_h_ = 0;
  BlockMatrix hessian_;
  SparseHessian preconditioner_;
  std::vector<double> constant_;  ///< of the preconditioner, without proximity and contact
  std::vector<char> touching_, factorised_touching_;
  std::vector<double> reach_;  ///< per vertex: how far it may move in this step
  /// Per vertex where its distance from the body was last measured, and that distance. [m]
  Positions measured_;
  std::vector<double> distance_;
  std::vector<Friction> frictions_;
  std::vector<std::optional<Vec3>> anchors_;  ///< per vertex
  std::vector<Pair> pairs_;                   ///< the last quasi-Newton steps
  double operations_ = 0;
};

}  // namespace seamwise
