#include "alignment/model/component.h"

#include <algorithm>
#include <numeric>

namespace seamwise {

std::vector<Component> componentsOf(const MatchProblem& problem) {
  std::vector<int> parent(problem.leaders.size());
  std::iota(parent.begin(), parent.end(), 0);
  auto root = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  auto pinned = [&](int l) { return problem.leaders[l].freedom.isPinned(); };
  for (const MatchSeam& seam : problem.seams)
    if (!pinned(seam.a) && !pinned(seam.b)) parent[root(seam.a)] = root(seam.b);
  std::vector<Component> components;
  std::vector<int> index(problem.leaders.size(), -1);
  for (std::size_t l = 0; l < problem.leaders.size(); ++l) {
    if (pinned(static_cast<int>(l)) || problem.leaders[l].seams.empty()) continue;
    int& at = index[root(static_cast<int>(l))];
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
