#include "alignment/leader_order.h"

#include <algorithm>
#include <numeric>

namespace seamwise {

std::vector<int> rankedLeaders(const MatchProblem& problem) {
  const std::size_t count = problem.leaders.size();
  std::vector<std::vector<int>> neighbours(count);
  for (const MatchSeam& seam : problem.seams) {
    neighbours[seam.a].push_back(seam.b);
    neighbours[seam.b].push_back(seam.a);
  }
  const auto fewer = [&](int l, int k) { return neighbours[l].size() < neighbours[k].size(); };
  std::vector<int> by_degree(count), order, ranks(count, -1);
  std::iota(by_degree.begin(), by_degree.end(), 0);
  std::stable_sort(by_degree.begin(), by_degree.end(), fewer);
  for (auto& around : neighbours) std::stable_sort(around.begin(), around.end(), fewer);
  const auto reach = [&](int leader) {
    if (ranks[leader] >= 0) return;
    ranks[leader] = static_cast<int>(count - 1 - order.size());
    order.push_back(leader);
  };
  for (const int start : by_degree) {
    const std::size_t from = order.size();
    reach(start);
    for (std::size_t k = from; k < order.size(); ++k)
      for (const int next : neighbours[order[k]]) reach(next);
  }
  return ranks;
}

}  // namespace seamwise
