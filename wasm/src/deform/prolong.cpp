#include "deform/prolong.h"

#include "tuning/shaping.h"

namespace seamwise {
namespace {

/// Moves of the vertices of a piece of the coarser pattern, in the frame of its part.
std::vector<Vec2> movesOf(const SeamFitting& from, int piece) {
  const Follower& follower = from.parts().pieces[piece];
  const PartDeformation& deformation = from.deformations()[follower.part];
  std::vector<Vec2> moves;
  for (std::size_t v = 0; v < follower.source.size(); ++v) {
    const int i = follower.source[v];
    Vec2 move = deformation.shape()[i] - deformation.part().rest[i];
    if (follower.reflected[v]) move.x() = -move.x();  // the axis is x = 0
    moves.push_back(move);
  }
  return moves;
}

/// Gives interior vertices the mean move of their neighbours, from the outline inwards.
void fillInterior(const Part& part, std::vector<char> known, std::vector<Vec2>& moves) {
  std::vector<std::vector<int>> neighbours(part.rest.size());
  for (const auto& t : part.triangles)
    for (int k = 0; k < 3; ++k) neighbours[t[k]].push_back(t[(k + 1) % 3]);
  std::vector<int> order;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i]) order.push_back(static_cast<int>(i));
  const std::size_t boundary = order.size();
  for (std::size_t k = 0; k < order.size(); ++k)
    for (int j : neighbours[order[k]])
      if (!known[j]) known[j] = 1, order.push_back(j);
  std::vector<char> filled(part.rest.size(), 0);
  for (std::size_t k = 0; k < boundary; ++k) filled[order[k]] = 1;
  for (int sweep = 0; sweep < ShapingTuning::kProlongSweeps; ++sweep) {
    for (std::size_t k = boundary; k < order.size(); ++k) {
      const int i = order[k];
      Vec2 sum = Vec2::Zero();
      int count = 0;
      for (int j : neighbours[i])
        if (filled[j]) sum += moves[j], ++count;
      if (count > 0) moves[i] = sum / count;
      filled[i] = 1;
    }
  }
}

}  // namespace

std::vector<PartDeformation::State> prolonged(const CoarserPattern& coarser,
                                              const SeamFitting& from, const SeamFitting& to) {
  std::vector<PartDeformation::State> states;
  for (const PartDeformation& deformation : to.deformations()) {
    const Part& part = deformation.part();
    const PartDeformation& coarse = from.deformations()[states.size()];
    const std::vector<Vec2> coarse_moves = movesOf(from, part.piece);
    const auto& places = coarser.places[part.piece];
    std::vector<Vec2> moves(part.rest.size(), Vec2::Zero());
    std::vector<char> known(part.rest.size(), 0);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const auto v = static_cast<std::size_t>(part.vertices[i]);
      if (v >= places.size()) continue;
      const CoarserPattern::Place& at = places[v];
      moves[i] = (1 - at.share) * coarse_moves[at.from] + at.share * coarse_moves[at.to];
      known[i] = 1;
    }
    fillInterior(part, std::move(known), moves);
    PartDeformation::State state = deformation.restState();
    for (std::size_t i = 0; i < moves.size(); ++i)
      for (int c = 0; c < 2; ++c)
        if (c == 1 || !part.onAxis(static_cast<int>(i))) state.shape[i][c] += moves[i][c];
    // A coarse edge's tension applies to all the fine edges it replaces.
    std::vector<int> edge_from(coarse.part().rest.size(), -1);
    for (std::size_t e = 0; e < coarse.part().edges.size(); ++e)
      edge_from[coarse.part().edges[e].i] = static_cast<int>(e);
    for (std::size_t e = 0; e < part.edges.size(); ++e) {
      const int v = coarse.part().local[places[part.vertices[part.edges[e].i]].from];
      if (v >= 0 && edge_from[v] >= 0)
        state.length_force[e] = coarse.state().length_force[edge_from[v]];
    }
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace seamwise
