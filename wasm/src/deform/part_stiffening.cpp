#include <algorithm>
#include <cmath>

#include "deform/part_deformation.h"
#include "tuning/shaping.h"

// Limits that a part breaks once its targets are fixed, and stiffening where it breaks them.

namespace seamwise {
PartDeformation::Violations PartDeformation::violations() const {
  const Part& part = plan_->part();
  Violations v;
  v.moved = last_move_;
  for (const Part::Edge& e : part.edges) {
    const double length = (state_.shape[e.i] - state_.shape[e.j]).norm();
    if (e.sewn) v.length = std::max(v.length, std::abs(length - e.length));
    const double rest = (part.rest[e.i] - part.rest[e.j]).norm();
    v.stretch = std::max(v.stretch, std::abs(length / rest - 1));
  }
  for (std::size_t i = 0; i < part.rest.size(); ++i)
    if (part.reach[i] > 0)
      v.reach = std::max(v.reach, (state_.shape[i] - part.rest[i]).norm() - part.reach[i]);
  for (const Part::Bend& b : part.bends)
    if (!b.corner) v.kink = std::max(v.kink, std::abs(kink(b)));
  for (std::size_t t = 0; t < part.triangles.size(); ++t)
    v.area = std::min(v.area, triangleArea(state_.shape, part.triangles[t]) / plan_->restArea(t));
  return v;
}

double PartDeformation::kink(const Part::Bend& b) const {
  auto turn = [&](const std::vector<Vec2>& x) {
    const Vec2 h = b.h >= 0 ? x[b.h] : Vec2(-x[b.j].x(), x[b.j].y());
    return turnAt(h, x[b.i], x[b.j]);
  };
  return turn(state_.shape) - turn(part().rest);
}

bool PartDeformation::stiffenKinks(double limit) {
  setUp();
  bool any = false;
  for (std::size_t b = 0; b < part().bends.size(); ++b) {
    if (part().bends[b].corner) continue;
    const double excess = std::abs(kink(part().bends[b])) / limit;
    if (excess <= 1) continue;
    if (!any) std::copy(constant_.begin(), constant_.end(), hessian_.values());
    any = true;
    const double before = bend_factor_[b];
    bend_factor_[b] *= ShapingTuning::kBendGrowth * excess * excess;
    plan_->terms().addBend(hessian_, part().bends[b],
                           plan_->weights().bend * (bend_factor_[b] - before));
  }
  if (any) constant_.assign(hessian_.values(), hessian_.values() + hessian_.nonZeros());
  return any;
}

void PartDeformation::stiffenStretched(double limit) {
  for (std::size_t e = 0; e < part().edges.size(); ++e) {
    const Part::Edge& edge = part().edges[e];
    if (edge.sewn) continue;
    const double rest = (part().rest[edge.i] - part().rest[edge.j]).norm();
    const double now = (state_.shape[edge.i] - state_.shape[edge.j]).norm();
    const double excess = std::abs(now / rest - 1) / limit;
    if (excess > 1)
      edge_factor_[e] = std::min(ShapingTuning::kMostStiffened,
                                 edge_factor_[e] * ShapingTuning::kEdgeGrowth * excess * excess);
  }
}

void PartDeformation::holdShape() {
  setUp();
  clearTargets();
  // The targets' pull balances the part's own force on the outline, so that only lengths and reach
  // remain to settle. Interior vertices are already in balance.
  const VectorX force = hessian_.times(constant_, moves());
  const std::vector<int>& unknown = plan_->terms().unknown;
  for (std::size_t i = 0; i < part().rest.size(); ++i) {
    if (part().reach[i] <= 0) continue;
    Vec2 pull = Vec2::Zero();
    for (int c = 0; c < 2; ++c)
      if (const int k = unknown[2 * i + c]; k >= 0) pull[c] = force[k];
    addTarget(static_cast<int>(i), state_.shape[i] + pull / (2 * ShapingTuning::kHold),
              ShapingTuning::kHold);
  }
  std::fill(state_.length_force.begin(), state_.length_force.end(), 0.0);
}

void PartDeformation::restart(double reach_factor) {
  const Part& part = plan_->part();
  // Faults are squeezed triangles and edges that miss their length.
  std::vector<char> faulty(part.rest.size(), 0);
  bool any = false;
  auto mark = [&](int v) {
    faulty[v] = 1;
    any = true;
  };
  for (std::size_t t = 0; t < part.triangles.size(); ++t)
    if (triangleArea(state_.shape, part.triangles[t]) <
        ShapingTuning::kSqueezed * plan_->restArea(t))
      for (int v : part.triangles[t]) mark(v);
  for (const Part::Edge& e : part.edges)
    if (e.sewn && std::abs((state_.shape[e.i] - state_.shape[e.j]).norm() - e.length) >
                      ShapingTuning::kMissedLength)
      mark(e.i), mark(e.j);
  for (std::size_t i = 0; i < reach_.size(); ++i) {
    bool near = !any;
    for (std::size_t k = 0; k < faulty.size() && !near; ++k)
      near = faulty[k] && (part.rest[i] - part.rest[k]).norm() < ShapingTuning::kNearFault;
    if (near) reach_[i] *= reach_factor;
  }
  state_ = restState();
}

}  // namespace seamwise
