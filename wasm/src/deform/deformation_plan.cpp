#include "deform/deformation_plan.h"

#include <algorithm>

#include "base/sort_by.h"
#include "deform/terms.h"
#include "tuning/shaping.h"

namespace seamwise {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

/// Pairs of vertices that occur in the same term, each pair once.
Pairs coupledVertices(const Part& part) {
  Pairs pairs;
  auto couple = [&](int a, int b) { pairs.emplace_back(std::min(a, b), std::max(a, b)); };
  for (const auto& t : part.triangles)
    for (int k = 0; k < 3; ++k) couple(t[k], t[(k + 1) % 3]);
  for (const Part::Bend& b : part.bends) {
    couple(b.i, b.j);
    if (b.h >= 0) couple(b.h, b.i), couple(b.h, b.j);
  }
  sortOnce(pairs);
  return pairs;
}

std::array<int, 10> slotsOf(const DeformationTerms& terms, int i, int j) {
  const SparseHessian& hessian = terms.quadratic;
  const std::vector<int>& unknown = terms.unknown;
  std::array<int, 10> slots;
  int k = 0;
  for (int v : {i, j})
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d <= c; ++d)
        slots[k++] = hessian.slot(unknown[2 * v + c], unknown[2 * v + d]);
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 2; ++d) slots[k++] = hessian.slot(unknown[2 * i + c], unknown[2 * j + d]);
  return slots;
}

}  // namespace

DeformationPlan::DeformationPlan(const Part& part, const DeformationWeights& weights)
    : part_(&part), weights_(weights) {
  rest_area_.reserve(part.triangles.size());
  for (const auto& t : part.triangles) rest_area_.push_back(triangleArea(part.rest, t));
}

DeformationTerms::DeformationTerms(const Part& part, const DeformationWeights& weights) {
  number(part);
  addConformal(part, weights.conformal);
  for (const Part::Bend& b : part.bends)
    addBend(quadratic, b, b.corner ? weights.corner : weights.bend);
  if (weights.line > 0) addLines(part, weights.line);
  for (std::size_t i = 0; i < part.rest.size(); ++i) {
    const double pull =
        part.reach[i] > 0 ? weights.rest : ShapingTuning::kInteriorPull * weights.rest;
    for (int c = 0; c < 2; ++c) quadratic.add(unknown[2 * i + c], unknown[2 * i + c], 2 * pull);
  }
  edge_slots.reserve(part.edges.size());
  for (const Part::Edge& e : part.edges) edge_slots.push_back(slotsOf(*this, e.i, e.j));
}

/// Numbers the unknowns in the order of elimination. Both coordinates of a vertex have the same
/// neighbours, so the order is one of vertices.
void DeformationTerms::number(const Part& part) {
  const int count = static_cast<int>(part.rest.size());
  const Pairs vertices = coupledVertices(part);
  const std::vector<int> position = eliminationOrder(count, vertices);
  std::vector<int> at(count);
  for (int v = 0; v < count; ++v) at[position[v]] = v;
  unknown.assign(2 * part.rest.size(), -1);
  for (int v : at) {
    if (!part.onAxis(v)) unknown[2 * v] = unknowns++;
    unknown[2 * v + 1] = unknowns++;
  }
  Pairs pairs;
  pairs.reserve(4 * vertices.size() + part.rest.size());
  for (int v = 0; v < count; ++v) pairs.emplace_back(unknown[2 * v], unknown[2 * v + 1]);
  for (const auto& [a, b] : vertices)
    for (int i = 0; i < 4; ++i) pairs.emplace_back(unknown[2 * a + i / 2], unknown[2 * b + i % 2]);
  quadratic = SparseHessian(unknowns, pairs, SparseHessian::Order::kGiven);
}

/// The conformal energy is quadratic and rest is its minimum, so only its Hessian is necessary.
void DeformationTerms::addConformal(const Part& part, double weight) {
  for (const auto& v : part.triangles) {
    const ConformalTriangle t =
        conformalTriangle(v, part.rest[v[0]], part.rest[v[1]], part.rest[v[2]]);
    const double w = 2 * weight * t.area;
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b <= a; ++b)
        quadratic.add(unknown[2 * v[a / 2] + a % 2], unknown[2 * v[b / 2] + b % 2],
                      w * (t.rows[0][a] * t.rows[0][b] + t.rows[1][a] * t.rows[1][b]));
  }
}

/// Keeps both ends of an unsewn edge on its line, w l (n . u)^2: a vertex between two of them moves
/// along the outline, a corner of two not at all.
void DeformationTerms::addLines(const Part& part, double weight) {
  for (const Part::Edge& edge : part.edges) {
    if (edge.sewn) continue;
    const Vec2 along = part.rest[edge.j] - part.rest[edge.i];
    const Vec2 normal = perp(along).normalized();
    const double w = weight * along.norm();
    for (const int v : {edge.i, edge.j})
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d <= c; ++d)
          quadratic.add(unknown[2 * v + c], unknown[2 * v + d], w * normal[c] * normal[d]);
  }
}

void DeformationTerms::addBend(SparseHessian& to, const Part::Bend& b, double weight) const {
  const double w = 2 * weight;
  if (b.h < 0) {  // u_h is u_j with x negated: only the y part is left, 2 (u_j - u_i) / after
    const double c = 2 / b.after;
    const int i = unknown[2 * b.i + 1], j = unknown[2 * b.j + 1];
    to.add(i, i, w * c * c), to.add(j, j, w * c * c), to.add(i, j, -w * c * c);
    return;
  }
  const int vertex[3] = {b.h, b.i, b.j};
  const double c[3] = {1 / b.before, -1 / b.before - 1 / b.after, 1 / b.after};
  for (int p = 0; p < 3; ++p)
    for (int q = 0; q <= p; ++q)
      for (int k = 0; k < 2; ++k)
        to.add(unknown[2 * vertex[p] + k], unknown[2 * vertex[q] + k], w * c[p] * c[q]);
}

}  // namespace seamwise
