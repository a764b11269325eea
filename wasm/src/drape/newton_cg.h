#pragma once
#include <optional>
#include <vector>

#include "drape/contacts.h"
#include "drape/terms.h"

namespace seamwise {

/// Options for the motion of a cloth on a body.
struct ClothOptions {
  double contact_stiffness = 1.8e6;  ///< N/m3; a tight waistband sinks in by 1 mm
  double friction_threshold = 1e-3;  ///< m, slip within which friction is elastic
  bool friction = true;
  double first_step = 0.05, longest_step = 0.3;  ///< s, time step of the proximal term
  double farthest = 0.02, farthest_near = 0.01;  ///< m, maximum movement in a step; near a body
  double near = 0.03;      ///< m, distance that counts as near: no vertex can pass a wrist
  double accuracy = 0.05;  ///< residual that ends a Newton step, relative to its first one
  int least_iterations = 1, most_iterations = 40;  ///< conjugate gradient iterations in a step
  std::vector<char> held;                          ///< per vertex: fixed; empty: none
  /// Per vertex: minimum x or, if negative, maximum x, m. 0: no bound; kInPlane: fixed at x = 0.
  /// Empty: no vertex is bound.
  std::vector<double> least_x;
  static constexpr double kInPlane = 1e9;
};

/// Moves a cloth on a body towards rest. Each step lowers the energy.
/// Both kinds of step use one scalar matrix for all coordinates that is factorised beforehand, the
/// constant one of projective dynamics. A Newton step uses conjugate gradients with this matrix as
/// preconditioner. A quasi-Newton step uses the matrix alone (Liu, Bouaziz, Kavan, "Quasi-Newton
/// Methods for Real-Time Simulation of Hyperelastic Materials", 2017). The object keeps pointers to
/// mesh, fabric, body and contacts.
class ClothSolver {
 public:
  struct Step {
    double energy = 0;    ///< J, after the step, without friction
    double fall = 0;      ///< J, decrease of the minimised energy
    double farthest = 0;  ///< m, largest movement of a vertex
    int iterations = 0;   ///< conjugate gradient iterations
    bool failed = false;  ///< no movement, because no step length lowers the energy
  };

  ClothSolver(const SewnMesh& mesh, const Fabric& fabric, const DistanceField& body,
              Positions start, ClothOptions options = {}, ClothContacts* contacts = nullptr);

  Step newtonStep();
  Step quasiNewtonStep();

  const Positions& positions() const { return x_; }
  /// Energy of membrane, bending, weight and contact. [J]
  double energy() const;
  /// Energy that lifts the cloth by a metre, a scale for other energies. [J]
  double weight() const;
  void setFriction(bool on);
  /// Switches the pull of the weight on or off; energy() includes the weight in both cases.
  void setWeight(bool on) { weighs_ = on; }
  /// Work so far, in factorisations of the matrix of a 90 x 90 grid with 2 unknowns per node.
  double work() const { return operations_ / kOperationsPerUnit; }

 private:
  /// Multiplications in the time of one factorisation of the grid; measured
  /// (tests/bench/drape_task.cpp).
  static constexpr double kOperationsPerUnit = 9e7;
  struct Pair {
    Positions moved, turned;  ///< changes of positions and of the gradient
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
  Positions from_;  ///< positions at the start of the step
  bool weighs_ = true;
  double h_;  ///< s, of the proximal term; above 0
  double factorised_h_ = 0;
  BlockMatrix hessian_;
  SparseHessian preconditioner_;
  std::vector<double> constant_;  ///< preconditioner without proximity and contact
  std::vector<char> touching_, factorised_touching_;
  std::vector<double> reach_;  ///< m, per vertex: maximum movement in this step
  /// Per vertex: position at the last distance measurement, and that distance. [m]
  Positions measured_;
  std::vector<double> distance_;
  std::vector<Friction> frictions_;
  std::vector<std::optional<Vec3>> anchors_;  ///< per vertex: point where friction holds it
  std::vector<Pair> pairs_;                   ///< the last quasi-Newton steps
  double operations_ = 0;
};

}  // namespace seamwise
