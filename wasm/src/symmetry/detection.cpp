#include "symmetry/detection.h"

#include <algorithm>
#include <optional>

#include "symmetry/symmetry.h"
#include "tuning/symmetry.h"

namespace seamwise {
namespace {

struct Solution {
  Assignment assignment;
  Coverage coverage;
};

// Grows involutions along seams. One map determines those of its neighbours, of their neighbours,
// and so on. This leaves few choices: one per region that no seam connects to a determined one.
class Search {
 public:
  explicit Search(const SeamMaps& maps) : maps_(maps) {}

  Solution solve(const std::vector<int>& seeds) const {
    const Solution empty{Assignment(maps_.pieces(), -1), {}};
    std::vector<Solution> starts = extensions(empty, seeds);
    Solution best = empty;
    for (int k = 0; k < SymmetryTuning::kFirstChoices && !starts.empty(); ++k) {
      const auto first = bestOf(starts);
      const Solution whole = completed(*first, seeds);
      if (whole.coverage.betterThan(best.coverage)) best = whole;
      starts.erase(first);
    }
    return best;
  }

 private:
  static std::vector<Solution>::iterator bestOf(std::vector<Solution>& solutions) {
    auto best = solutions.begin();
    for (auto it = solutions.begin(); it != solutions.end(); ++it)
      if (it->coverage.betterThan(best->coverage)) best = it;
    return best;
  }

  // Adds one map and all maps that follow from it to a solution; returns every distinct outcome
  // once.
  std::vector<Solution> extensions(const Solution& base, const std::vector<int>& seeds) const {
    std::vector<Solution> found;
    std::vector<char> seen(maps_.maps().size(), 0);
    for (const int seed : seeds) {
      if (seen[seed]) continue;
      Solution next = base;
      const std::vector<int> added = maps_.propagate(seed, next.assignment);
      if (added.empty()) continue;
      for (const int piece : added) seen[next.assignment[piece]] = 1;
      const Coverage gain = maps_.coverage(next.assignment, added);
      if (!supported(next.assignment, added, gain)) continue;
      next.coverage = base.coverage + gain;
      found.push_back(std::move(next));
    }
    return found;
  }

  Solution completed(Solution solution, const std::vector<int>& seeds) const {
    for (;;) {
      std::vector<Solution> next = extensions(solution, seeds);
      if (next.empty()) return solution;
      solution = *bestOf(next);
    }
  }

  // Simple shapes mirror by chance. A mirror of sewn pieces counts only if a seam or the placement
  // supports it.
  bool supported(const Assignment& assignment, const std::vector<int>& added,
                 const Coverage& gain) const {
    if (gain.seams > 0) return true;
    return std::all_of(added.begin(), added.end(), [&](int piece) {
      return !maps_.sewn(piece) ||
             (maps_.placement().known() &&
              maps_.maps()[assignment[piece]].disagreement <= SymmetryTuning::kPlacementSlack);
    });
  }

  const SeamMaps& maps_;
};

// Solves every seam-connected part alone, then pairs parts as mirror images of each other if that
// explains more (two trouser legs that are sewn to nothing else).
Assignment solveGarment(const SeamMaps& maps) {
  const Search search(maps);
  const std::vector<int> label = maps.components();
  const int n = maps.pieces();
  const auto seeds = [&](int from, int to) {
    std::vector<int> found;
    for (int m = 0; m < static_cast<int>(maps.maps().size()); ++m)
      if (label[maps.maps()[m].from] == from && label[maps.maps()[m].to] == to) found.push_back(m);
    return found;
  };
  std::vector<std::optional<Solution>> own(n);
  for (int k = 0; k < n; ++k)
    if (label[k] == k) own[k] = search.solve(seeds(k, k));

  struct Crossing {
    int parts[2];
    Solution solution;
  };
  std::vector<Crossing> crossings;
  for (int k = 0; k < n; ++k)
    for (int l = k + 1; l < n; ++l) {
      if (!own[k] || !own[l]) continue;
      Solution both = search.solve(seeds(k, l));
      if (both.coverage.betterThan(own[k]->coverage + own[l]->coverage))
        crossings.push_back({{k, l}, std::move(both)});
    }

  Assignment assignment(n, -1);
  const auto take = [&](const Solution& solution) {
    for (int i = 0; i < n; ++i)
      if (solution.assignment[i] >= 0) assignment[i] = solution.assignment[i];
  };
  while (!crossings.empty()) {
    const auto best =
        std::min_element(crossings.begin(), crossings.end(), [](const auto& x, const auto& y) {
          return x.solution.coverage.betterThan(y.solution.coverage);
        });
    const int k = best->parts[0], l = best->parts[1];
    take(best->solution);
    own[k].reset();
    own[l].reset();
    crossings.erase(
        std::remove_if(crossings.begin(), crossings.end(),
                       [&](const Crossing& c) { return !own[c.parts[0]] || !own[c.parts[1]]; }),
        crossings.end());
  }
  for (const std::optional<Solution>& solution : own)
    if (solution) take(*solution);
  return assignment;
}

}  // namespace

int likeliestMap(const SeamMaps& maps, const std::vector<int>& candidates) {
  int best = -1;
  Coverage most;
  for (const int m : candidates) {
    Assignment assignment(maps.pieces(), -1);
    const std::vector<int> added = maps.propagate(m, assignment);
    const Coverage coverage = maps.coverage(assignment, added);
    if (best >= 0 && !coverage.betterThan(most)) continue;
    best = m;
    most = coverage;
  }
  return best;
}

BodySymmetry bodySymmetry(const Garment& garment, int from, int to,
                          const MirrorRegistration& registration) {
  const double exact = edgewiseResidual(garment.panels[from], garment.panels[to], registration.map);
  return {{from, to}, registration.map, std::min(registration.residual, exact)};
}

std::vector<BodySymmetry> SymmetryDetection::found() const {
  const Assignment assignment = solveGarment(maps_);
  std::vector<BodySymmetry> found;
  for (int i = 0; i < maps_.pieces(); ++i) {
    if (assignment[i] < 0) continue;
    const PieceMap& map = maps_.maps()[assignment[i]];
    if (map.from <= map.to)
      found.push_back(bodySymmetry(maps_.garment(), map.from, map.to, map.registration));
  }
  return found;
}

std::vector<BodySymmetry> detectSymmetries(const Garment& garment) {
  SymmetryDetection detection(garment);
  while (detection.advance()) {
  }
  return detection.found();
}

}  // namespace seamwise
