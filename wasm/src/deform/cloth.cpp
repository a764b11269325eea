#include "deform/cloth.h"

#include <algorithm>
#include <cmath>

#include "deform/terms.h"

namespace seamwise {
namespace {

constexpr double kLengthPenalty = 2e4;  ///< per cm2
constexpr double kReachPenalty = 4e3;  ///< per cm2; pulls are about 1 a cm, so the excess is slight
constexpr double kUpright = 0.33;      ///< least area of a triangle, as a share of its rest area
constexpr double kLongestStep = 0.4;   ///< cm: beyond it the linearised lengths are worthless

Cloth::State restStateOf(const Part& part) {
  return {part.rest, VectorX::Zero(part.unknowns), std::vector<double>(part.edges.size(), 0)};
}

/// Pairs of unknowns of which a term depends on both, each once.
std::vector<std::pair<int, int>> coupledUnknowns(const Part& part) {
  std::vector<std::pair<int, int>> vertices;
  auto couple = [&](int a, int b) { vertices.emplace_back(std::min(a, b), std::max(a, b)); };
  for (const auto& t : part.triangles)
    for (int k = 0; k < 3; ++k) couple(t[k], t[(k + 1) % 3]);
  for (const Part::Bend& b : part.bends) {
    couple(b.i, b.j);
    if (b.h >= 0) couple(b.h, b.i), couple(b.h, b.j);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<std::pair<int, int>> unknowns;
  unknowns.reserve(4 * vertices.size() + part.rest.size());
  for (std::size_t v = 0; v < part.rest.size(); ++v)
    unknowns.emplace_back(part.unknown[2 * v], part.unknown[2 * v + 1]);
  for (const auto& [a, b] : vertices)
    for (int i = 0; i < 4; ++i)
      unknowns.emplace_back(part.unknown[2 * a + i / 2], part.unknown[2 * b + i % 2]);
  return unknowns;
}

/// Of the lower triangles of the blocks (i, i) and (j, j), then of the block (i, j).
std::array<int, 10> slotsOf(const SparseHessian& hessian, const Part& part, int i, int j) {
  std::array<int, 10> slots;
  int k = 0;
  for (int v : {i, j})
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d <= c; ++d)
        slots[k++] = hessian.slot(part.unknown[2 * v + c], part.unknown[2 * v + d]);
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 2; ++d)
      slots[k++] = hessian.slot(part.unknown[2 * i + c], part.unknown[2 * j + d]);
  return slots;
}

}  // namespace

Cloth::State Cloth::restState() const { return restStateOf(*part_); }

Cloth::Cloth(const Part& part, const ClothWeights& weights)
    : part_(&part),
      weights_(weights),
      state_(restStateOf(part)),
      reach_(part.reach),
      target_weight_(part.rest.size(), 0),
      target_pull_(part.rest.size(), Vec2::Zero()),
      bend_factor_(part.bends.size(), 1) {
  rest_area_.resize(part.triangles.size());
  for (std::size_t t = 0; t < part.triangles.size(); ++t)
    rest_area_[t] = triangleArea(part.rest, static_cast<int>(t));
}

/// The hessian and what never changes in it; parts that rest need neither.
void Cloth::setUp() {
  const Part& part = *part_;
  hessian_ = SparseHessian(part.unknowns, coupledUnknowns(part));
  gradient_ = VectorX::Zero(part.unknowns);
  edge_slots_.reserve(part.edges.size());
  for (const Part::Edge& e : part.edges) edge_slots_.push_back(slotsOf(hessian_, part, e.i, e.j));
  hessian_.setZero();
  addConformal();
  for (const Part::Bend& b : part.bends) addBend(b, b.corner ? weights_.corner : weights_.bend);
  for (std::size_t i = 0; i < part.rest.size(); ++i) {
    const double pull = part.reach[i] > 0 ? weights_.rest : 1e-4 * weights_.rest;
    for (int c = 0; c < 2; ++c)
      hessian_.add(part.unknown[2 * i + c], part.unknown[2 * i + c], 2 * pull);
  }
  constant_.assign(hessian_.values(), hessian_.values() + hessian_.nonZeros());
}

double Cloth::triangleArea(const std::vector<Vec2>& x, int t) const {
  const auto& [i, j, k] = part_->triangles[t];
  return cross(x[j] - x[i], x[k] - x[i]) / 2;
}

/// The conformal energy is quadratic and rest is its minimum, so it needs no more than its Hessian.
void Cloth::addConformal() {
  for (const auto& v : part_->triangles) {
    const ConformalTriangle t =
        conformalTriangle(v, part_->rest[v[0]], part_->rest[v[1]], part_->rest[v[2]]);
    const double w = 2 * weights_.conformal * t.area;
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b <= a; ++b)
        hessian_.add(part_->unknown[2 * v[a / 2] + a % 2], part_->unknown[2 * v[b / 2] + b % 2],
                     w * (t.rows[0][a] * t.rows[0][b] + t.rows[1][a] * t.rows[1][b]));
  }
}

/// w |(u_j - u_i) / after - (u_i - u_h) / before|^2: the outline's direction keeps turning as at
/// rest.
void Cloth::addBend(const Part::Bend& b, double weight) {
  const auto& unknown = part_->unknown;
  const double w = 2 * weight;
  if (b.h < 0) {  // u_h is u_j with x negated: only the y part is left, 2 (u_j - u_i) / after
    const double c = 2 / b.after;
    const int i = unknown[2 * b.i + 1], j = unknown[2 * b.j + 1];
    hessian_.add(i, i, w * c * c), hessian_.add(j, j, w * c * c), hessian_.add(i, j, -w * c * c);
    return;
  }
  const int vertex[3] = {b.h, b.i, b.j};
  const double c[3] = {1 / b.before, -1 / b.before - 1 / b.after, 1 / b.after};
  for (int p = 0; p < 3; ++p)
    for (int q = 0; q <= p; ++q)
      for (int k = 0; k < 2; ++k)
        hessian_.add(unknown[2 * vertex[p] + k], unknown[2 * vertex[q] + k], w * c[p] * c[q]);
}

void Cloth::clearTargets() {
  std::fill(target_weight_.begin(), target_weight_.end(), 0.0);
  std::fill(target_pull_.begin(), target_pull_.end(), Vec2::Zero());
}

void Cloth::addTarget(int vertex, const Vec2& position, double weight) {
  target_weight_[vertex] += weight;
  target_pull_[vertex] += weight * position;
}

VectorX Cloth::quadraticForce(const VectorX& u) const { return hessian_.times(constant_, u); }

/// The energy as a function of the shape, targets and multipliers held.
double Cloth::energy(const std::vector<Vec2>& shape, const VectorX& u) const {
  const Part& part = *part_;
  double e = u.dot(quadraticForce(u)) / 2;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    if (target_weight_[i] > 0)
      e += target_weight_[i] * shape[i].squaredNorm() - 2 * target_pull_[i].dot(shape[i]);
    if (part.reach[i] <= 0) continue;
    const double excess = (shape[i] - part.rest[i]).norm() - reach_[i];
    if (excess > 0) e += kReachPenalty * excess * excess / 2;
  }
  for (std::size_t k = 0; k < part.edges.size(); ++k) {
    const Part::Edge& edge = part.edges[k];
    const double c = (shape[edge.i] - shape[edge.j]).norm() - edge.length;
    e += state_.length_force[k] * c + stiffness(edge) * c * c / 2;
  }
  return e;
}

double Cloth::stiffness(const Part::Edge& edge) const {
  return edge.sewn ? kLengthPenalty : weights_.unsewn;
}

/// Gradient and Gauss-Newton Hessian at the present shape.
void Cloth::assemble() {
  const Part& part = *part_;
  std::copy(constant_.begin(), constant_.end(), hessian_.values());
  gradient_ = quadraticForce(state_.u);
  auto addGradient = [&](int vertex, const Vec2& g) {
    for (int c = 0; c < 2; ++c)
      if (part.unknown[2 * vertex + c] >= 0) gradient_[part.unknown[2 * vertex + c]] += g[c];
  };
  for (std::size_t i = 0; i < part.rest.size(); ++i) {
    const int v = static_cast<int>(i);
    if (target_weight_[i] > 0) {
      const double w = 2 * target_weight_[i];
      for (int c = 0; c < 2; ++c) hessian_.add(part.unknown[2 * i + c], part.unknown[2 * i + c], w);
      addGradient(v, w * state_.shape[i] - 2 * target_pull_[i]);
    }
    if (part.reach[i] <= 0) continue;
    const Vec2 move = state_.shape[i] - part.rest[i];
    const double length = move.norm(), excess = length - reach_[i];
    if (excess <= 0 || length < 1e-9) continue;
    const Vec2 n = move / length;
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d <= c; ++d)
        hessian_.add(part.unknown[2 * i + c], part.unknown[2 * i + d], kReachPenalty * n[c] * n[d]);
    addGradient(v, kReachPenalty * excess * move / length);
  }
  for (std::size_t e = 0; e < part.edges.size(); ++e) {
    const Part::Edge& edge = part.edges[e];
    const Vec2 d = state_.shape[edge.i] - state_.shape[edge.j];
    const double length = d.norm();
    const double force = state_.length_force[e] + stiffness(edge) * (length - edge.length);
    const Vec2 n = d / length;
    const double w = stiffness(edge), xx = w * n.x() * n.x(), xy = w * n.x() * n.y(),
                 yy = w * n.y() * n.y();
    const double entries[10] = {xx, xy, yy, xx, xy, yy, -xx, -xy, -xy, -yy};
    for (int k = 0; k < 10; ++k)
      if (const int slot = edge_slots_[e][k]; slot >= 0) hessian_.values()[slot] += entries[k];
    addGradient(edge.i, force * d / length);
    addGradient(edge.j, -force * d / length);
  }
}

void Cloth::step() {
  const Part& part = *part_;
  if (constant_.empty()) setUp();
  assemble();
  ++factorisations_;
  last_move_ = 0;
  if (!hessian_.factorise()) return;
  const VectorX full = -hessian_.solve(gradient_);
  auto moveOf = [&](std::size_t i, int c) {
    const int k = part.unknown[2 * i + c];
    return k < 0 ? 0.0 : full[k];
  };
  double longest = 0;
  for (std::size_t i = 0; i < part.rest.size(); ++i)
    longest = std::max(longest, std::hypot(moveOf(i, 0), moveOf(i, 1)));
  double scale = std::min(1.0, kLongestStep / std::max(longest, 1e-12));
  const double before = energy(state_.shape, state_.u), slope = gradient_.dot(full);
  std::vector<Vec2> trial(state_.shape.size());
  for (int halving = 0; halving < 12; ++halving, scale /= 2) {
    for (std::size_t i = 0; i < trial.size(); ++i)
      trial[i] = state_.shape[i] + scale * Vec2(moveOf(i, 0), moveOf(i, 1));
    bool upright = true;
    for (std::size_t t = 0; t < part.triangles.size() && upright; ++t)
      upright = triangleArea(trial, static_cast<int>(t)) > kUpright * rest_area_[t];
    if (!upright) continue;
    const VectorX moved_u = state_.u + scale * full;
    // below rounding there is nothing left to compare
    const double slack = 1e-12 * (std::abs(before) + 1);
    if (energy(trial, moved_u) > before + 1e-4 * scale * slope + slack) continue;
    state_.shape.swap(trial);
    state_.u = moved_u;
    last_move_ = scale * longest;
    break;
  }
  for (std::size_t e = 0; e < part.edges.size(); ++e) {
    const Part::Edge& edge = part.edges[e];
    if (!edge.sewn) continue;
    const double length = (state_.shape[edge.i] - state_.shape[edge.j]).norm();
    state_.length_force[e] += kLengthPenalty * (length - edge.length);
  }
}

}  // namespace seamwise
