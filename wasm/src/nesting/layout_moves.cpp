// Where a piece of a layout overlaps the others the least, and where it lies the lowest.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

#include "base/lanes.h"
#include "base/sort_by.h"
#include "nesting/layout_search.h"

namespace seamwise {
namespace {

constexpr float kFlawWeight = 1000;   ///< nothing is worth lying on a flaw
constexpr int kRowReads = 30;         ///< what beginning a row takes, in reads; measured
constexpr double kLookupReads = 12;   ///< and what reading a single dot takes
constexpr std::size_t kDescents = 6;  ///< from the best dots that were looked at

int floorDiv(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }
int ceilDiv(int a, int b) { return -floorDiv(-a, b); }

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

void LayoutSearch::scoreRow(const std::vector<Other>& others, int j, const DotRun& run) {
  scores_.assign(run.size(), 0);
  const int stride = pieces_.stride();
  for (const Other& other : others) {
    const DifferenceTable& table = *other.table;
    const int row = j - other.dot.j;
    if (row < table.rows().lo || row > table.rows().hi) continue;
    const DotRun columns = table.columns();
    const int lo = std::max(run.lo, other.dot.i + columns.lo);
    const int hi = std::min(run.hi, other.dot.i + columns.hi);
    for (int first = lo; first <= std::min(hi, lo + stride - 1); ++first) {
      const std::uint16_t* depths = table.from({first - other.dot.i, row});
      for (int i = first, k = 0; i <= hi; i += stride, ++k)
        scores_[i - run.lo] += other.weight * static_cast<float>(depths[k]);
    }
    if (hi >= lo) reads_ += 2 * (hi - lo) + kRowReads;
  }
  reads_ += run.size() + kRowReads;
}

/// Scores of all dots of a domain's box whose rows and columns leave the rests of `phase`.
void LayoutSearch::scoreSome(const std::vector<Other>& others, const Domain& domain, Dot phase) {
  const int stride = pieces_.stride();
  constexpr int kFar = 1 << 29;
  DotRun box{kFar, -kFar};
  for (const DotRun& run : domain.runs) {
    if (run.empty()) continue;
    box.lo = std::min(box.lo, run.lo);
    box.hi = std::max(box.hi, run.hi);
  }
  // dot = stride * number + rest
  const auto numbers = [&](const DotRun& run, int rest) {
    return DotRun{ceilDiv(run.lo - rest, stride), floorDiv(run.hi - rest, stride)};
  };
  some_columns_ = numbers(box, phase.i);
  some_rows_ = numbers(domain.rows(), phase.j);
  const std::size_t width = some_columns_.size();
  scores_.assign(width * some_rows_.size(), 0);
  for (const Other& other : others) {
    const DifferenceTable& table = *other.table;
    const Dot off = phase - other.dot;  // difference = stride * number + off
    DotRun columns = numbers(table.columns(), off.i), rows = numbers(table.rows(), off.j);
    columns = {std::max(columns.lo, some_columns_.lo), std::min(columns.hi, some_columns_.hi)};
    rows = {std::max(rows.lo, some_rows_.lo), std::min(rows.hi, some_rows_.hi)};
    if (columns.empty()) continue;
    for (int j = rows.lo; j <= rows.hi; ++j) {
      addWeighted(table.from({stride * columns.lo + off.i, stride * j + off.j}), columns.size(),
                  other.weight,
                  scores_.data() + (j - some_rows_.lo) * width + (columns.lo - some_columns_.lo));
      reads_ += columns.size() + kRowReads;
    }
  }
  reads_ += static_cast<double>(scores_.size()) + kRowReads;
}

float LayoutSearch::scoreAt(const std::vector<Other>& others, Dot dot) {
  float sum = 0;
  for (const Other& other : others)
    sum += other.weight * static_cast<float>(other.table->depth(dot - other.dot));
  reads_ += kLookupReads * static_cast<double>(others.size());
  return sum;
}

/// From dots that were looked at to a better one between them.
void LayoutSearch::descend(const std::vector<Other>& others, const Domain& domain, Found* found) {
  for (int step = pieces_.stride() / 2; step > 0 && found->score > 0;) {
    Found best = *found;
    for (int j = -step; j <= step; j += step) {
      for (int i = -step; i <= step; i += step) {
        const Dot dot = found->place.dot + Dot{i, j};
        if ((i == 0 && j == 0) || !domain.has(dot)) continue;
        const float score = scoreAt(others, dot);
        if (score < best.score) best = {{found->place.way, dot}, score};
      }
    }
    if (best.score == found->score) step /= 2;
    *found = best;
  }
}

LayoutSearch::Found LayoutSearch::leastOverlap(int item) {
  if (pieces_.items()[item].is_pinned) return {places_[item], 0};
  Found best{{}, std::numeric_limits<float>::infinity()};
  const int stride = pieces_.stride();
  int ties = 0;
  for (const int way : ways_[item]) {
    const int placed = pieces_.items()[item].ways[way].placed;
    const Domain& domain = domains_[placed];
    const std::vector<Other> others = othersOf(item, placed, true);
    const Dot phase{random_.below(stride), random_.below(stride)};
    scoreSome(others, domain, phase);
    std::vector<std::pair<double, std::size_t>> rows;
    for (int n = some_rows_.lo; n <= some_rows_.hi; ++n) {
      const DotRun& run = domain.row(stride * n + phase.j);
      const int lo = ceilDiv(run.lo - phase.i, stride), hi = floorDiv(run.hi - phase.i, stride);
      if (hi < lo) continue;
      const float* scores = scores_.data() +
                            static_cast<std::size_t>(n - some_rows_.lo) * some_columns_.size() +
                            (lo - some_columns_.lo);
      const int count = hi - lo + 1;
      const float least = leastOf(scores, count);
      if (stride == 1 && least > best.score) continue;
      const int equal = static_cast<int>(std::count(scores, scores + count, least));
      int nth = equal == 1 ? 0 : random_.below(equal);
      int k = 0;
      while (scores[k] != least || nth-- > 0) ++k;
      const Found found{{way, {stride * (lo + k) + phase.i, stride * n + phase.j}}, least};
      if (least < best.score) ties = 0;
      if (least <= best.score) {
        ties += equal;
        if (random_.below(ties) < equal) best = found;
      }
      if (stride > 1) {
        candidates_.push_back(found);
        rows.emplace_back(least, candidates_.size() - 1);
      }
    }
    if (stride == 1 || best.score == 0) {
      candidates_.clear();
      continue;
    }
    sortKeyed(rows);
    for (std::size_t k = 0; k < std::min(rows.size(), kDescents); ++k) {
      Found found = candidates_[rows[k].second];
      descend(others, domain, &found);
      if (found.score >= best.score) continue;
      best = found;
      ties = 1;
    }
    candidates_.clear();
  }
  return best.place.way >= 0 ? best : leastBetween(item);
}

/// The same where domains are so small that they lie between the dots that are looked at.
LayoutSearch::Found LayoutSearch::leastBetween(int item) {
  Found best{{}, std::numeric_limits<float>::infinity()};
  for (const int way : ways_[item]) {
    const int placed = pieces_.items()[item].ways[way].placed;
    const Domain& domain = domains_[placed];
    const auto run = std::find_if(domain.runs.begin(), domain.runs.end(),
                                  [](const DotRun& one) { return !one.empty(); });
    if (run == domain.runs.end()) continue;
    const std::vector<Other> others = othersOf(item, placed, true);
    const Dot dot{run->lo, domain.first + static_cast<int>(run - domain.runs.begin())};
    Found found{{way, dot}, scoreAt(others, dot)};
    descend(others, domain, &found);
    if (found.score < best.score) best = found;
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
        return pieces_.topAt(placed, {i, j}, cloth_.origin) +
               1e-4 * pieces_.at(placed, {i, j}, cloth_.origin).x();
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
