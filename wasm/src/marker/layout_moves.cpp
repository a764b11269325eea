// The position with the least overlap of a piece with the others, and its lowest free position.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

#include "base/lanes.h"
#include "base/sort_by.h"
#include "marker/layout_search.h"

namespace seamwise {
namespace {

constexpr float kFlawWeight = 1000;  ///< prevents pieces on flaws
constexpr int kRowReads = 30;        ///< cost of starting a row, in reads; measured

using Floats = Lanes<float>::Vector;

void addWeighted(const std::uint16_t* depths, int count, float weight, float* into) {
  using Depths __attribute__((vector_size(8))) = std::uint16_t;
  constexpr int kLanes = Lanes<float>::kCount;
  int k = 0;
  for (; k + kLanes <= count; k += kLanes) {
    Depths of;
    std::memcpy(&of, depths + k, sizeof of);
    const Floats sum = loaded(into + k) + weight * __builtin_convertvector(of, Floats);
    std::memcpy(into + k, &sum, sizeof sum);
  }
  for (; k < count; ++k) into[k] += weight * static_cast<float>(depths[k]);
}

float leastOf(const float* numbers, std::size_t count) {
  constexpr std::size_t kLanes = Lanes<float>::kCount;
  constexpr float kMost = std::numeric_limits<float>::infinity();
  Floats lanes = {kMost, kMost, kMost, kMost};
  std::size_t k = 0;
  for (; k + kLanes <= count; k += kLanes) lanes = least(lanes, loaded(numbers + k));
  float all = std::min(std::min(lanes[0], lanes[1]), std::min(lanes[2], lanes[3]));
  for (; k < count; ++k) all = std::min(all, numbers[k]);
  return all;
}

}  // namespace

std::vector<LayoutSearch::Other> LayoutSearch::othersOf(int item, int placed, bool weighted) const {
  std::vector<Other> others;
  for (int other = 0; other < count_; ++other) {
    if (other == item || places_[other].way < 0) continue;
    const int theirs = pieces_.items()[other].ways[places_[other].way].placed;
    others.push_back({&pieces_.table(theirs, placed), places_[other].dot,
                      weighted ? weights_[static_cast<std::size_t>(item) * count_ + other] : 1});
  }
  for (const DifferenceTable& flaw : flaws_[placed]) others.push_back({&flaw, {0, 0}, kFlawWeight});
  return others;
}

/// Computes the scores of a row's dots.
void LayoutSearch::scoreRow(const std::vector<Other>& others, int j, const DotRun& run) {
  scores_.assign(run.size(), 0);
  for (const Other& other : others) {
    const DifferenceTable& table = *other.table;
    const int row = j - other.dot.j;
    if (row < table.rows().lo || row > table.rows().hi) continue;
    const DotRun columns = table.columns();
    const int lo = std::max(run.lo, other.dot.i + columns.lo);
    const int hi = std::min(run.hi, other.dot.i + columns.hi);
    if (hi < lo) continue;
    addWeighted(table.from({lo - other.dot.i, row}), hi - lo + 1, other.weight,
                scores_.data() + (lo - run.lo));
    reads_ += hi - lo + 1 + kRowReads;
  }
  reads_ += run.size() + kRowReads;
}

LayoutSearch::Found LayoutSearch::leastOverlap(int item) {
  if (pieces_.items()[item].is_pinned) return {places_[item], 0};
  if (pieces_.isFine()) return leastOfSome(item);
  Found best{{}, std::numeric_limits<float>::infinity()};
  int ties = 0;
  for (const int way : ways_[item]) {
    const int placed = pieces_.items()[item].ways[way].placed;
    const Domain& domain = domains_[placed];
    const std::vector<Other> others = othersOf(item, placed, true);
    for (int j = domain.first; j <= domain.rows().hi; ++j) {
      const DotRun& run = domain.row(j);
      if (run.empty()) continue;
      scoreRow(others, j, run);
      const float* scores = scores_.data();
      const float least = leastOf(scores, run.size());
      if (least > best.score) continue;
      const int equal = static_cast<int>(std::count(scores, scores + run.size(), least));
      int nth = equal == 1 ? 0 : random_.below(equal);
      int k = 0;
      while (scores[k] != least || nth-- > 0) ++k;
      if (least < best.score) ties = 0;
      ties += equal;
      if (random_.below(ties) < equal) best = {{way, {run.lo + k, j}}, least};
    }
  }
  return best;
}

std::optional<LayPlace> LayoutSearch::lowest(int item) {
  std::optional<LayPlace> best;
  double least = std::numeric_limits<double>::infinity();
  for (const int way : ways_[item]) {
    const int placed = pieces_.items()[item].ways[way].placed;
    const Domain& domain = domains_[placed];
    const std::vector<Other> others = othersOf(item, placed, false);
    const bool is_level = pieces_.board().along.y() == 0;
    for (int j = domain.first; j <= domain.rows().hi; ++j) {
      const DotRun& run = domain.row(j);
      if (run.empty()) continue;
      const auto cost = [&](int i) {
        return pieces_.topAt(placed, {i, j}, fabric_.origin) +
               1e-4 * pieces_.at(placed, {i, j}, fabric_.origin).x();
      };
      if (is_level && cost(run.lo) >= least) break;  // higher rows cost more
      scoreRow(others, j, run);
      bool is_found = false;
      for (int k = 0; k < run.size(); ++k) {
        if (scores_[k] > 0 || cost(run.lo + k) >= least) continue;
        least = cost(run.lo + k);
        best = {way, {run.lo + k, j}};
        is_found = true;
        if (is_level) break;
      }
      if (is_found && is_level) break;
    }
  }
  return best;
}

}  // namespace seamwise
