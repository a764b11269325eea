#include "deform/fitting.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "deform/shape_limits.h"
#include "tuning/shaping.h"

namespace seamwise {
namespace {

constexpr double kLockedReach = 1e-5;  ///< cm

}  // namespace

SeamFitting::SeamFitting(const FittingPlan& plan, const Pattern& pattern,
                         const WallpaperGroup& group, const FittingRules& rules)
    : plan_(plan),
      pattern_(pattern),
      group_(group),
      rules_(rules),
      joins_(pattern.seams.size()),
      pulls_(pattern.seams.size(), 1),
      shapes_(restShapes(pattern)) {
  deformations_.reserve(plan.deformations.size());
  for (const DeformationPlan& deformation : plan.deformations)
    deformations_.emplace_back(deformation);
  lock();
  setPulls(pulls_);
  collectShapes();
}

/// Marks the vertices of locked edges in their part, which a piece and its mirror image share.
void SeamFitting::lock() {
  for (const PartDeformation& deformation : deformations_)
    locked_.emplace_back(deformation.shape().size(), 0);
  for (const EdgeRef& edge : rules_.locked) {
    const Piece& piece = pattern_.pieces[edge.piece];
    const auto& start = piece.edge_start;
    const std::size_t next = static_cast<std::size_t>(edge.edge) + 1;
    const int n = static_cast<int>(piece.outline.size());
    const int last = next < start.size() ? start[next] : n;
    const Follower& f = plan_.parts.pieces[edge.piece];
    for (int k = start[edge.edge]; k <= last; ++k)
      locked_[f.part][f.source[piece.outline[k % n]]] = 1;
  }
}

bool SeamFitting::isLocked(int piece, int vertex) const {
  const Follower& f = plan_.parts.pieces[piece];
  return locked_[f.part][f.source[vertex]];
}

void SeamFitting::setPulls(const std::vector<double>& pulls) {
  pulls_ = pulls;
  std::vector<std::vector<double>> limits;
  for (const std::vector<char>& locked : locked_) {
    limits.emplace_back(locked.size(), std::numeric_limits<double>::infinity());
    for (std::size_t v = 0; v < locked.size(); ++v)
      if (locked[v]) limits.back()[v] = kLockedReach;
  }
  for (std::size_t s = 0; s < pulls_.size(); ++s) {
    if (pulls_[s] > 0) continue;
    for (const SeamSide* side : {&pattern_.seams[s].a, &pattern_.seams[s].b}) {
      const Follower& f = plan_.parts.pieces[side->piece];
      for (std::size_t k = 1; k + 1 < side->vertices.size(); ++k) {
        double& limit = limits[f.part][f.source[side->vertices[k]]];
        limit = std::min(limit, ShapingTuning::kLineReach);
      }
    }
  }
  for (std::size_t c = 0; c < deformations_.size(); ++c) deformations_[c].limitReach(limits[c]);
}

void SeamFitting::collectShapes() {
  for (std::size_t p = 0; p < shapes_.size(); ++p) {
    const Follower& f = plan_.parts.pieces[p];
    const auto& local = deformations_[f.part].shape();
    for (std::size_t v = 0; v < shapes_[p].size(); ++v)
      shapes_[p][v] = f.at(static_cast<int>(v), local[f.source[v]]);
  }
}

std::vector<PartDeformation::State> SeamFitting::states() const {
  std::vector<PartDeformation::State> states;
  for (const PartDeformation& deformation : deformations_) states.push_back(deformation.state());
  return states;
}

std::vector<PartDeformation::State> SeamFitting::restStates() const {
  std::vector<PartDeformation::State> states;
  for (const PartDeformation& deformation : deformations_)
    states.push_back(deformation.restState());
  return states;
}

void SeamFitting::setStates(std::vector<PartDeformation::State> states) {
  for (std::size_t k = 0; k < deformations_.size(); ++k)
    deformations_[k].setState(std::move(states[k]));
  collectShapes();
}

void SeamFitting::chooseJoins(const std::vector<Alignment>& at) {
  for (std::size_t s = 0; s < joins_.size(); ++s)
    joins_[s] = bestJoin(group_, pattern_.seams[s], shapes_, at, rules_.continuous_only);
}

void SeamFitting::addTarget(int piece, int vertex, const Vec2& position, double weight,
                            const PartDeformation* only) {
  const Follower& f = plan_.parts.pieces[piece];
  if (only && only != &deformations_[f.part]) return;
  const PointMap& back =
      f.reflected[vertex] ? plan_.to_part_mirror[piece] : plan_.to_part_direct[piece];
  deformations_[f.part].addTarget(f.source[vertex], back(position), weight);
}

void SeamFitting::step(const std::vector<Alignment>& at) {
  aim(at, nullptr);
  for (PartDeformation& deformation : deformations_) deformation.step();
  collectShapes();
}

void SeamFitting::aimAtPartners(const PartDeformation& deformation,
                                const std::vector<Alignment>& at) {
  aim(at, &deformation);
}

/// Target lines of both sides of a seam, on equivalent points of the print: in the middle, or at
/// the locked side.
IdealLines SeamFitting::linesOf(const Seam& seam, const Join& join,
                                const std::vector<Alignment>& at) const {
  if (rules_.average_shapes) return idealLines(seam, join, shapes_, at, IdealShape::kAveraged);
  const Alignment &wa = at[seam.a.piece], &wb = at[seam.b.piece];
  const Element& g = join.element;
  const Mat2 back = g.A.inverse();
  // Same as Alignment::toPrint and toPiece, with sines and cosines computed once for all points.
  const Mat2 to_a = rotation(wa.angle), to_b = rotation(wb.angle);
  const Mat2 from_a = to_a.transpose(), from_b = to_b.transpose();
  IdealLines lines;
  for (std::size_t k = 0; k < seam.a.vertices.size(); ++k) {
    const Vec2 x = from_a * (shapes_[seam.a.piece][seam.a.vertices[k]] - wa.translation);
    const Vec2 y = g(from_b * (shapes_[seam.b.piece][seam.b.vertices[k]] - wb.translation));
    const bool a_stays = isLocked(seam.a.piece, seam.a.vertices[k]);
    const bool b_stays = isLocked(seam.b.piece, seam.b.vertices[k]);
    const Vec2 middle = a_stays == b_stays ? Vec2((x + y) / 2) : a_stays ? x : y;
    lines.a.push_back(to_a * middle + wa.translation);
    lines.b.push_back(to_b * (back * (middle - g.a)) + wb.translation);
  }
  return lines;
}

/// Sets the targets of all parts, or of only one.
void SeamFitting::aim(const std::vector<Alignment>& at, const PartDeformation* only) {
  for (PartDeformation& deformation : deformations_)
    if (!only || only == &deformation) deformation.clearTargets();
  for (std::size_t s = 0; s < joins_.size(); ++s) {
    const Seam& seam = pattern_.seams[s];
    if (!seam.matched || seam.twin || pulls_[s] <= 0) continue;
    const IdealLines lines = linesOf(seam, joins_[s], at);
    const double pull =
        pulls_[s] * seam.weight * (isGathered(seam) ? ShapingTuning::kGatheredPull : 1);
    for (std::size_t k = 0; k < seam.a.vertices.size(); ++k) {
      const int va = seam.a.vertices[k], vb = seam.b.vertices[k];
      // The distance that both sides have to move together: the mismatch, if they meet in the
      // middle.
      const double apart = (lines.a[k] - shapes_[seam.a.piece][va]).norm() +
                           (lines.b[k] - shapes_[seam.b.piece][vb]).norm();
      const double weight =
          pull * plan_.vertex_length[s][k] / std::max(apart, ShapingTuning::kLeastDistance);
      addTarget(seam.a.piece, va, lines.a[k], weight, only);
      addTarget(seam.b.piece, vb, lines.b[k], weight, only);
    }
  }
}

bool SeamFitting::crosses(int piece) const {
  return crossesItself(pattern_.pieces[piece], shapes_[piece]);
}

int SeamFitting::factorisations() const {
  int total = 0;
  for (const PartDeformation& deformation : deformations_) total += deformation.factorisations();
  return total;
}

}  // namespace seamwise
