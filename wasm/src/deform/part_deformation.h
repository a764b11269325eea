#pragma once
#include <vector>

#include "deform/deformation_plan.h"

namespace seamwise {

/// Deforms one part towards targets by a safeguarded Newton iteration. Conformal, bending and
/// target terms are quadratic. An augmented Lagrangian keeps the length of sewn edges and the reach
/// of vertices. A step is shortened until every triangle keeps its orientation.
///
/// E(u) = sum w |x - x*|^2 + conformal + bend + rest + unsewn + AL(lengths) + AL(reach),
/// x = rest + u
class PartDeformation {
 public:
  /// @param plan   outlives the deformation
  explicit PartDeformation(const DeformationPlan& plan);

  const Part& part() const { return plan_->part(); }
  const std::vector<Vec2>& shape() const { return state_.shape; }

  void clearTargets();
  /// @param weight   per cm2; several targets of a vertex add up
  void addTarget(int vertex, const Vec2& position, double weight);

  /// Limits the movement of outline vertices in addition to the part's reach; 0 or more. [cm, per
  /// vertex]
  void limitReach(const std::vector<double>& limits);

  /// One Newton step and one update of the multipliers.
  void step();

  /// Variables that steps change, except for targets.
  struct State {
    std::vector<Vec2> shape;           ///< per vertex, in the part's frame, cm
    std::vector<double> length_force;  ///< per outline edge: multiplier of its length, per cm
  };
  const State& state() const { return state_; }
  void setState(State state) { state_ = std::move(state); }
  /// The state as drafted.
  State restState() const;

  int settling = 0;  ///< steps since the targets were fixed; for the caller's use
  int factorisations() const { return factorisations_; }

  /// Deviations of a shape from the limits of a finished one.
  struct Violations {
    double length = 0;   ///< greatest |edge - kept length| of a sewn edge, cm
    double reach = 0;    ///< greatest excess over the reach, cm
    double kink = 0;     ///< greatest change of direction at a smooth vertex, rad
    double stretch = 0;  ///< greatest relative change of an outline edge
    double area = 1;     ///< least ratio of a triangle's area to its rest area
    double moved = 0;    ///< greatest movement in the last step, cm
  };
  Violations violations() const;

  /// Stiffens the outline where it bends by more than `limit` rad. Returns whether it stiffened any
  /// bend.
  bool stiffenKinks(double limit);
  /// Stiffens unsewn edges whose relative change of length exceeds `limit`.
  void stiffenStretched(double limit);
  /// Brings the current shape into balance, so that only lengths and reach have to settle.
  void holdShape();
  /// Restarts from rest with the current targets, with less reach around faulty vertices.
  void restart(double reach_factor);

 private:
  VectorX moves() const;  ///< moves of the unknowns
  double outlineEnergy(const std::vector<Vec2>& shape) const;
  double stiffness(std::size_t edge) const;
  void setUp();
  void assemble(const VectorX& quadratic_force);
  double kink(const Part::Bend& bend) const;  ///< change of the turn at a smooth vertex, rad

  const DeformationPlan* plan_;
  State state_;
  std::vector<double> reach_;
  SparseHessian hessian_;
  std::vector<double> constant_;       ///< values of the quadratic terms, in the hessian's pattern
  std::vector<double> target_weight_;  ///< per vertex
  std::vector<Vec2> target_pull_;      ///< per vertex: sum of w x*
  std::vector<double> bend_factor_;    ///< per bend, 1 at first
  std::vector<double> edge_factor_;    ///< per unsewn edge, 1 at first
  VectorX gradient_;
  double last_move_ = 0;
  int factorisations_ = 0;
};

}  // namespace seamwise
