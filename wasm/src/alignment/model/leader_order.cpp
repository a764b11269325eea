#include "alignment/model/leader_order.h"

#include <numeric>

#include "base/sort_by.h"

namespace seamwise {

std::vector<int> rankedLeaders(const MatchProblem& problem) {
  const std::size_t count = problem.leaders.size();
  std::vector<std::vector<int>> neighbours(count);
  for (const MatchSeam& seam : problem.seams) {
    neighbours[seam.a].push_back(seam.b);
    neighbours[seam.b].push_back(seam.a);
  }
  const auto degree = [&](int l) { return neighbours[l].size(); };
  std::vector<int> by_degree(count), order, ranks(count, -1);
  std::iota(by_degree.begin(), by_degree.end(), 0);
  sortBy(by_degree, degree);
  for (auto& around : neighbours) sortBy(around, degree);
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
