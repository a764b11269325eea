#include "alignment/model/component.h"

#include <algorithm>

#include "base/disjoint_sets.h"

namespace seamwise {

std::vector<Component> componentsOf(const MatchProblem& problem) {
  DisjointSets sets(static_cast<int>(problem.leaders.size()));
  auto pinned = [&](int l) { return problem.leaders[l].admissible.isPinned(); };
  for (const MatchSeam& seam : problem.seams)
    if (!pinned(seam.a) && !pinned(seam.b)) sets.join(seam.a, seam.b);
  std::vector<Component> components;
  std::vector<int> index(problem.leaders.size(), -1);
  for (std::size_t l = 0; l < problem.leaders.size(); ++l) {
    if (pinned(static_cast<int>(l)) || problem.leaders[l].seams.empty()) continue;
    int& at = index[sets.find(static_cast<int>(l))];
    if (at < 0) {
      at = static_cast<int>(components.size());
      components.emplace_back();
    }
    components[at].leaders.push_back(static_cast<int>(l));
  }
  for (Component& c : components) {
    for (int l : c.leaders)
      c.seams.insert(c.seams.end(), problem.leaders[l].seams.begin(),
                     problem.leaders[l].seams.end());
    std::sort(c.seams.begin(), c.seams.end());
    c.seams.erase(std::unique(c.seams.begin(), c.seams.end()), c.seams.end());
  }
  return components;
}

}  // namespace seamwise
