#include "alignment/search/finalists.h"

#include <algorithm>
#include <numeric>

#include "alignment/search/search_moves.h"
#include "base/sort_by.h"

namespace seamwise {
namespace {

constexpr double kEqual = 1e-6;  ///< answers whose costs differ by less are as good as each other
constexpr int kFirstIterations = 3;  ///< iterations on all edges that tell which finalists go on
constexpr std::size_t kPolished = 12;
constexpr int kPolish = 30;  ///< iterations at most

}  // namespace

std::vector<std::pair<double, Alignments>> finalistsOf(
    std::vector<std::pair<double, Alignments>> all,
    const std::function<double(Alignments& own, int iterations)>& improve) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  const auto sort = [&](int iterations) {
    for (const std::size_t k : order) all[k].first = improve(all[k].second, iterations);
    sortBy(order, [&](std::size_t k) { return all[k].first; });
  };
  sort(kFirstIterations);
  if (order.size() > kPolished) order.resize(kPolished);
  sort(kPolish);
  std::vector<std::pair<double, Alignments>> finalists;
  for (std::size_t k = 0; k < order.size();) {
    const double least = all[order[k]].first;
    std::size_t first = order[k];
    for (; k < order.size() && all[order[k]].first <= least * (1 + SearchMoves::kSame); ++k)
      if (all[order[k]].first <= least * (1 + kEqual)) first = std::min(first, order[k]);
    finalists.push_back(std::move(all[first]));
  }
  return finalists;
}

}  // namespace seamwise
