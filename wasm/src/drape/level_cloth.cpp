#include "drape/level_cloth.h"

#include "drape/drape_check.h"

namespace seamwise {

LevelCloth::LevelCloth(const SewnMesh& mesh, const std::vector<int>& image, const Layers& layers,
                       const Fabric& fabric, const DistanceField& body, const Positions& start,
                       ClothOptions options)
    : mesh_(&mesh), half_(halved(mesh, image, start)), x_(start) {
  if (half_) options.least_x = leastX(layers.gap);
  const HeldLayers held = half_ ? heldOfHalf(layers.held) : layers.held;
  contacts_ = std::make_unique<ClothContacts>(
      solved(), layers.overlaps, held.ties, held.laps,
      half_ && !layers.laid.empty() ? half_->half(layers.laid) : layers.laid, layers.gap);
  solver_ =
      std::make_unique<ClothSolver>(solved(), fabric, body, half_ ? half_->half(start) : start,
                                    std::move(options), contacts_.get());
}

/// Returns the layers of this half.
HeldLayers LevelCloth::heldOfHalf(const HeldLayers& held) const {
  HeldLayers own;
  for (const int v : half_->vertex) own.laps.push_back(held.laps[v]);
  for (ClothTie tie : held.ties) {
    bool inside = true;
    for (ClothPoint* point : {&tie.a, &tie.b})
      for (int& v : point->vertices) {
        v = half_->in_half[v];
        inside = inside && v >= 0;
      }
    if (inside) own.ties.push_back(tie);
  }
  return own;
}

/// Returns the minimum x per vertex: half a gap, but a quarter within two edges of where the cloth
/// continues on the other side.
std::vector<double> LevelCloth::leastX(double gap) const {
  std::vector<double> least(solved().size, gap / 2);
  for (int i = 0; i < solved().size; ++i)
    if (half_->inPlane(i)) least[i] = ClothOptions::kInPlane;
  for (int ring = 0; ring < 2; ++ring) {
    std::vector<int> beside;
    for (const auto& [a, b] : solved().edges())
      for (const auto& [own, other] : {std::pair(a, b), {b, a}})
        if (least[own] == gap / 2 && least[other] != gap / 2) beside.push_back(own);
    for (const int i : beside) least[i] = gap / 4;
  }
  return least;
}

ClothSolver::Step LevelCloth::taken(ClothSolver::Step step) {
  x_ = half_ ? half_->whole(solver_->positions()) : solver_->positions();
  step.energy *= sides(), step.fall *= sides();
  return step;
}

int LevelCloth::crossings() const {
  const Positions& x = solver_->positions();
  std::size_t count = crossingsOf(solved(), x).size();
  // A vertex beyond the plane crosses its mirror image.
  for (std::size_t i = 0; half_ && i < x.size(); ++i) count += x[i].x() < 0;
  return static_cast<int>(count);
}

}  // namespace seamwise
