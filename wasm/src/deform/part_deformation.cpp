#include "deform/part_deformation.h"

#include <algorithm>
#include <cmath>

#include "tuning/shaping.h"

namespace seamwise {
PartDeformation::State PartDeformation::restState() const {
  return {part().rest, std::vector<double>(part().edges.size(), 0)};
}

PartDeformation::PartDeformation(const DeformationPlan& plan)
    : plan_(&plan),
      state_(restState()),
      reach_(plan.part().reach),
      target_weight_(plan.part().rest.size(), 0),
      target_pull_(plan.part().rest.size(), Vec2::Zero()),
      bend_factor_(plan.part().bends.size(), 1),
      edge_factor_(plan.part().edges.size(), 1) {}

/// Sets up the Hessian on first use; parts at rest need none.
void PartDeformation::setUp() {
  if (!constant_.empty()) return;
  hessian_ = plan_->terms().quadratic;
  constant_.assign(hessian_.values(), hessian_.values() + hessian_.nonZeros());
}

void PartDeformation::clearTargets() {
  std::fill(target_weight_.begin(), target_weight_.end(), 0.0);
  std::fill(target_pull_.begin(), target_pull_.end(), Vec2::Zero());
}

void PartDeformation::addTarget(int vertex, const Vec2& position, double weight) {
  target_weight_[vertex] += weight;
  target_pull_[vertex] += weight * position;
}

void PartDeformation::limitReach(const std::vector<double>& limits) {
  for (std::size_t i = 0; i < reach_.size(); ++i) reach_[i] = std::min(part().reach[i], limits[i]);
}

VectorX PartDeformation::moves() const {
  const DeformationTerms& terms = plan_->terms();
  VectorX u(terms.unknowns);
  for (std::size_t i = 0; i < state_.shape.size(); ++i)
    for (int c = 0; c < 2; ++c)
      if (const int k = terms.unknown[2 * i + c]; k >= 0)
        u[k] = state_.shape[i][c] - part().rest[i][c];
  return u;
}

/// The energy without its quadratic terms, for fixed targets and multipliers. It depends on the
/// outline alone.
double PartDeformation::outlineEnergy(const std::vector<Vec2>& shape) const {
  double e = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (target_weight_[i] > 0)
      e += target_weight_[i] * shape[i].squaredNorm() - 2 * target_pull_[i].dot(shape[i]);
    if (part().reach[i] <= 0) continue;
    const double excess = (shape[i] - part().rest[i]).norm() - reach_[i];
    if (excess > 0) e += ShapingTuning::kReachPenalty * excess * excess / 2;
  }
  for (std::size_t k = 0; k < part().edges.size(); ++k) {
    const Part::Edge& edge = part().edges[k];
    const double c = (shape[edge.i] - shape[edge.j]).norm() - edge.length;
    e += state_.length_force[k] * c + stiffness(k) * c * c / 2;
  }
  return e;
}

double PartDeformation::stiffness(std::size_t edge) const {
  const Part::Edge& e = part().edges[edge];
  if (e.sewn) return ShapingTuning::kLengthPenalty / std::min(1.0, e.length);
  return plan_->weights().unsewn * edge_factor_[edge];
}

/// Computes gradient and Gauss-Newton Hessian at the current shape.
void PartDeformation::assemble(const VectorX& quadratic_force) {
  const Part& part = plan_->part();
  const std::vector<int>& unknown = plan_->terms().unknown;
  std::copy(constant_.begin(), constant_.end(), hessian_.values());
  gradient_ = quadratic_force;
  auto addGradient = [&](int vertex, const Vec2& g) {
    for (int c = 0; c < 2; ++c)
      if (unknown[2 * vertex + c] >= 0) gradient_[unknown[2 * vertex + c]] += g[c];
  };
  for (std::size_t i = 0; i < part.rest.size(); ++i) {
    const int v = static_cast<int>(i);
    if (target_weight_[i] > 0) {
      const double w = 2 * target_weight_[i];
      for (int c = 0; c < 2; ++c) hessian_.add(unknown[2 * i + c], unknown[2 * i + c], w);
      addGradient(v, w * state_.shape[i] - 2 * target_pull_[i]);
    }
    if (part.reach[i] <= 0) continue;
    const Vec2 move = state_.shape[i] - part.rest[i];
    const double length = move.norm(), excess = length - reach_[i];
    if (excess <= 0 || length < 1e-9) continue;
    const Vec2 n = move / length;
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d <= c; ++d)
        hessian_.add(unknown[2 * i + c], unknown[2 * i + d],
                     ShapingTuning::kReachPenalty * n[c] * n[d]);
    addGradient(v, ShapingTuning::kReachPenalty * excess * move / length);
  }
  for (std::size_t e = 0; e < part.edges.size(); ++e) {
    const Part::Edge& edge = part.edges[e];
    const Vec2 d = state_.shape[edge.i] - state_.shape[edge.j];
    const double length = d.norm();
    const double force = state_.length_force[e] + stiffness(e) * (length - edge.length);
    const Vec2 n = d / length;
    const double w = stiffness(e), xx = w * n.x() * n.x(), xy = w * n.x() * n.y(),
                 yy = w * n.y() * n.y();
    const double entries[10] = {xx, xy, yy, xx, xy, yy, -xx, -xy, -xy, -yy};
    for (int k = 0; k < 10; ++k)
      if (const int slot = plan_->terms().edge_slots[e][k]; slot >= 0)
        hessian_.values()[slot] += entries[k];
    addGradient(edge.i, force * d / length);
    addGradient(edge.j, -force * d / length);
  }
}

void PartDeformation::step() {
  const Part& part = plan_->part();
  setUp();
  const std::vector<int>& unknown = plan_->terms().unknown;
  const VectorX u = moves(), force = hessian_.times(constant_, u);
  assemble(force);
  ++factorisations_;
  last_move_ = 0;
  if (!hessian_.factorise()) return;
  const VectorX full = -hessian_.solve(gradient_);
  auto moveOf = [&](std::size_t i, int c) {
    const int k = unknown[2 * i + c];
    return k < 0 ? 0.0 : full[k];
  };
  double longest = 0;
  for (std::size_t i = 0; i < part.rest.size(); ++i)
    longest = std::max(longest, std::hypot(moveOf(i, 0), moveOf(i, 1)));
  double scale = std::min(1.0, ShapingTuning::kLongestStep / std::max(longest, 1e-12));
  // The quadratic terms along the step, by Taylor expansion.
  const double at_start = u.dot(force) / 2, first = force.dot(full);
  const double second = full.dot(hessian_.times(constant_, full)) / 2;
  const double before = at_start + outlineEnergy(state_.shape), slope = gradient_.dot(full);
  std::vector<Vec2> trial(state_.shape.size());
  for (int halving = 0; halving < 12; ++halving, scale /= 2) {
    for (std::size_t i = 0; i < trial.size(); ++i)
      trial[i] = state_.shape[i] + scale * Vec2(moveOf(i, 0), moveOf(i, 1));
    bool upright = true;
    for (std::size_t t = 0; t < part.triangles.size() && upright; ++t)
      upright =
          triangleArea(trial, part.triangles[t]) > ShapingTuning::kLeastArea * plan_->restArea(t);
    if (!upright) continue;
    const double after = at_start + scale * (first + scale * second) + outlineEnergy(trial);
    // Differences below rounding errors are not comparable.
    const double slack = 1e-12 * (std::abs(before) + 1);
    if (after > before + 1e-4 * scale * slope + slack) continue;
    state_.shape.swap(trial);
    last_move_ = scale * longest;
    break;
  }
  for (std::size_t e = 0; e < part.edges.size(); ++e) {
    const Part::Edge& edge = part.edges[e];
    if (!edge.sewn) continue;
    const double length = (state_.shape[edge.i] - state_.shape[edge.j]).norm();
    state_.length_force[e] += stiffness(e) * (length - edge.length);
  }
}

}  // namespace seamwise
