#include "deform/fitting.h"

#include <Eigen/LU>
#include <algorithm>

#include "geometry/polygon.h"

namespace seamwise {
namespace {

constexpr double kFloor = 0.05;        ///< cm: mismatch below it pulls no harder than this
constexpr double kGatheredPull = 0.3;  ///< of a seam that cannot match all along

}  // namespace

SeamFitting::SeamFitting(const Pattern& pattern, const WallpaperGroup& group,
                         const FittingRules& rules)
    : pattern_(pattern),
      group_(group),
      rules_(rules),
      parts_(splitIntoParts(pattern, rules.max_change)),
      joins_(pattern.seams.size()) {
  cloths_.reserve(parts_.parts.size());
  for (const Part& part : parts_.parts) cloths_.emplace_back(part, rules.weights);
  for (const Follower& f : parts_.pieces) {
    to_part_direct_.push_back(f.direct.inverse());
    to_part_mirror_.push_back(f.mirror.inverse());
  }
  shapes_.resize(pattern.pieces.size());
  for (std::size_t p = 0; p < shapes_.size(); ++p) shapes_[p] = pattern.pieces[p].rest;
  collectShapes();
  vertex_length_.resize(pattern.seams.size());
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    const SeamSide& a = pattern.seams[s].a;
    const auto& rest = pattern.pieces[a.piece].rest;
    vertex_length_[s].assign(a.vertices.size(), 0);
    for (std::size_t i = 0; i + 1 < a.vertices.size(); ++i) {
      const double l = (rest[a.vertices[i + 1]] - rest[a.vertices[i]]).norm();
      vertex_length_[s][i] += l / 2, vertex_length_[s][i + 1] += l / 2;
    }
  }
}

void SeamFitting::collectShapes() {
  for (std::size_t p = 0; p < shapes_.size(); ++p) {
    const Follower& f = parts_.pieces[p];
    const auto& local = cloths_[f.part].shape();
    for (std::size_t v = 0; v < shapes_[p].size(); ++v)
      shapes_[p][v] = f.at(static_cast<int>(v), local[f.source[v]]);
  }
}

std::vector<Cloth::State> SeamFitting::states() const {
  std::vector<Cloth::State> states;
  for (const Cloth& cloth : cloths_) states.push_back(cloth.state());
  return states;
}

std::vector<Cloth::State> SeamFitting::restStates() const {
  std::vector<Cloth::State> states;
  for (const Cloth& cloth : cloths_) states.push_back(cloth.restState());
  return states;
}

void SeamFitting::setStates(std::vector<Cloth::State> states) {
  for (std::size_t k = 0; k < cloths_.size(); ++k) cloths_[k].setState(std::move(states[k]));
  collectShapes();
}

void SeamFitting::chooseJoins(const std::vector<Alignment>& at) {
  for (std::size_t s = 0; s < joins_.size(); ++s)
    joins_[s] = bestJoin(group_, pattern_.seams[s], shapes_, at, rules_.continuous_only);
}

void SeamFitting::addTarget(int piece, int vertex, const Vec2& position, double weight,
                            const Cloth* only) {
  const Follower& f = parts_.pieces[piece];
  if (only && only != &cloths_[f.part]) return;
  const PointMap& back = f.reflected[vertex] ? to_part_mirror_[piece] : to_part_direct_[piece];
  cloths_[f.part].addTarget(f.source[vertex], back(position), weight);
}

void SeamFitting::step(const std::vector<Alignment>& at) {
  aim(at, nullptr);
  for (Cloth& cloth : cloths_) cloth.step();
  collectShapes();
}

void SeamFitting::aimAtPartners(const Cloth& cloth, const std::vector<Alignment>& at) {
  aim(at, &cloth);
}

/// Where both sides of a seam should lie, on equivalent points of the print.
IdealLines SeamFitting::linesOf(const Seam& seam, const Join& join,
                                const std::vector<Alignment>& at) const {
  if (rules_.average_shapes) return idealLines(seam, join, shapes_, at, IdealShape::kAveraged);
  const Alignment &wa = at[seam.a.piece], &wb = at[seam.b.piece];
  const Element& g = join.element;
  const Mat2 back = g.A.inverse();
  // as Alignment::toPrint and toPiece, with sines and cosines once for all points
  const Mat2 to_a = rotation(wa.angle), to_b = rotation(wb.angle);
  const Mat2 from_a = to_a.transpose(), from_b = to_b.transpose();
  IdealLines lines;
  for (std::size_t k = 0; k < seam.a.vertices.size(); ++k) {
    const Vec2 x = from_a * (shapes_[seam.a.piece][seam.a.vertices[k]] - wa.translation);
    const Vec2 y = g(from_b * (shapes_[seam.b.piece][seam.b.vertices[k]] - wb.translation));
    const Vec2 middle = (x + y) / 2;
    lines.a.push_back(to_a * middle + wa.translation);
    lines.b.push_back(to_b * (back * (middle - g.a)) + wb.translation);
  }
  return lines;
}

/// Targets of all parts, or of only one.
void SeamFitting::aim(const std::vector<Alignment>& at, const Cloth* only) {
  for (Cloth& cloth : cloths_)
    if (!only || only == &cloth) cloth.clearTargets();
  for (std::size_t s = 0; s < joins_.size(); ++s) {
    const Seam& seam = pattern_.seams[s];
    if (!seam.matched || seam.twin) continue;
    const IdealLines lines = linesOf(seam, joins_[s], at);
    const double pull = seam.weight * (isGathered(seam) ? kGatheredPull : 1);
    for (std::size_t k = 0; k < seam.a.vertices.size(); ++k) {
      const int va = seam.a.vertices[k], vb = seam.b.vertices[k];
      // what both sides have to move together: the mismatch, when they meet in the middle
      const double apart = (lines.a[k] - shapes_[seam.a.piece][va]).norm() +
                           (lines.b[k] - shapes_[seam.b.piece][vb]).norm();
      const double weight = pull * vertex_length_[s][k] / std::max(apart, kFloor);
      addTarget(seam.a.piece, va, lines.a[k], weight, only);
      addTarget(seam.b.piece, vb, lines.b[k], weight, only);
    }
  }
}

bool SeamFitting::crosses(int piece) const {
  std::vector<Polyline> loops;
  for (const std::vector<int>& loop : loopsOf(pattern_.pieces[piece])) {
    loops.emplace_back();
    for (int v : loop) loops.back().push_back(shapes_[piece][v]);
  }
  return findCrossing(loops).has_value();
}

int SeamFitting::factorisations() const {
  int total = 0;
  for (const Cloth& cloth : cloths_) total += cloth.factorisations();
  return total;
}

}  // namespace seamwise
