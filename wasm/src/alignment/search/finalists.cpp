#include "alignment/search/finalists.h"

#include <algorithm>
#include <numeric>

#include "alignment/search/search_moves.h"
#include "base/sort_by.h"
#include "tuning/search.h"

namespace seamwise {
std::vector<std::pair<double, Alignments>> finalistsOf(
    std::vector<std::pair<double, Alignments>> all,
    const std::function<double(Alignments& own, int iterations)>& improve) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  const auto sort = [&](int iterations) {
    for (const std::size_t k : order) all[k].first = improve(all[k].second, iterations);
    sortBy(order, [&](std::size_t k) { return all[k].first; });
  };
  sort(SearchTuning::kFinalistIterations);
  if (order.size() > SearchTuning::kPolished) order.resize(SearchTuning::kPolished);
  sort(SearchTuning::kPolishIterations);
  std::vector<std::pair<double, Alignments>> finalists;
  for (std::size_t k = 0; k < order.size();) {
    const double least = all[order[k]].first;
    std::size_t first = order[k];
    for (; k < order.size() && all[order[k]].first <= least * (1 + SearchTuning::kSameAnswer); ++k)
      if (all[order[k]].first <= least * (1 + SearchTuning::kEqualCost))
        first = std::min(first, order[k]);
    finalists.push_back(std::move(all[first]));
  }
  return finalists;
}

}  // namespace seamwise
