#include "nesting/layout_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>

#include "base/lanes.h"

namespace seamwise {
namespace {

constexpr std::size_t kMostBeginnings = 24;
constexpr double kShorter = 0.01;    ///< cm by which a shorter layout is shorter at least
constexpr double kFirstShrink = 0.04;
constexpr float kFlawWeight = 1000;  ///< nothing is worth lying on a flaw
constexpr int kIdleSweeps = 40;      ///< without less overlap, before something else is tried
constexpr int kRowReads = 30;        ///< what beginning a row takes, in reads; measured
constexpr int kRestarts = 6;         ///< before a target less far is

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

float leastOf(const std::vector<float>& numbers) {
  constexpr std::size_t kLanes = Lanes<float>::kCount;
  constexpr float kMost = std::numeric_limits<float>::infinity();
  Floats lanes = {kMost, kMost, kMost, kMost};
  std::size_t k = 0;
  for (; k + kLanes <= numbers.size(); k += kLanes) lanes = least(lanes, loaded(&numbers[k]));
  float all = std::min(std::min(lanes[0], lanes[1]), std::min(lanes[2], lanes[3]));
  for (; k < numbers.size(); ++k) all = std::min(all, numbers[k]);
  return all;
}

}  // namespace

LayoutSearch::LayoutSearch(const PiecesOnBoard& pieces, LayCloth cloth, std::uint64_t seed)
    : pieces_(pieces),
      cloth_(std::move(cloth)),
      random_(seed),
      count_(static_cast<int>(pieces.items().size())),
      ways_(allowedWays(pieces, cloth_)),
      beginnings_(beginnings(pieces, cloth_, kMostBeginnings)),
      shrink_(pieces.isFine() ? kFirstShrink : 0) {
  for (int placed = 0; placed < pieces.placedCount(); ++placed)
    flaws_.push_back(pieces.flawTables(placed, cloth_.origin));
  places_.resize(count_);
  weights_.assign(static_cast<std::size_t>(count_) * count_, 1);
  overlaps_.assign(weights_.size(), 0);
  flaw_overlaps_.assign(count_, 0);
  std::vector<int> order(count_);
  std::iota(order.begin(), order.end(), 0);
  const auto size = [&](int item, int by) -> double {
    if (ways_[item].empty()) return 0;
    const Shape& shape = pieces.shapeOf(pieces.items()[item].ways[ways_[item].front()]);
    const Vec2 box = shape.high - shape.low;
    return by == 0 ? shape.area : by == 1 ? box.y() : box.x();
  };
  for (int by = 0; by < 3; ++by) {
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return size(a, by) > size(b, by); });
    // what is pinned is there already
    std::vector<int> all = order;
    std::stable_partition(all.begin(), all.end(),
                          [&](int item) { return pieces.items()[item].is_pinned; });
    orders_.push_back(std::move(all));
  }
}

bool LayoutSearch::construct() {
  if (next_ == orders_.size() * beginnings_.size() || homeless_ >= 0) return false;
  const std::size_t by = next_ % orders_.size(), from = next_ / orders_.size();
  ++next_;
  // tall enough for a loose layout; one that needs more is given more
  const double width = std::max(cloth_.right - cloth_.left, 1.0);
  double tallest = 0;
  for (int placed = 0; placed < pieces_.placedCount(); ++placed)
    tallest = std::max(tallest, pieces_.shape(placed).high.y() - pieces_.shape(placed).low.y());
  const double repeat = pieces_.period().value_or(100.0);
  double length = 2 * pieces_.area() / width + 2 * tallest + 2 * repeat;
  for (int times = 0; times < 8; ++times, length *= 2) {
    setWindow(beginnings_[from], length);
    if (layInOrder(orders_[by])) {
      LaidPieces layout{places_};
      measure(pieces_, cloth_, &layout);
      offer(layout);
      return true;
    }
    for (int item = 0; item < count_; ++item)
      if (!hasPlace(item)) homeless_ = item;
    // longer windows have rows like those of this one
    if (homeless_ >= 0 && (times > 0 || pieces_.period())) return false;
    homeless_ = -1;
  }
  for (int item = 0; item < count_ && homeless_ < 0; ++item)
    if (places_[item].way < 0) homeless_ = item;
  return false;
}

void LayoutSearch::offer(const LaidPieces& layout) {
  if (best_ && layout.length() > best_->length() - kShorter) return;
  best_ = layout;
  beginning_ = cloth_.is_fixed ? 0 : layout.bottom;
  is_under_way_ = false;
}

bool LayoutSearch::hasPlace(int item) const {
  return std::any_of(ways_[item].begin(), ways_[item].end(), [&](int way) {
    const Domain& domain = domains_[pieces_.items()[item].ways[way].placed];
    return std::any_of(domain.runs.begin(), domain.runs.end(),
                       [](const DotRun& run) { return !run.empty(); });
  });
}

void LayoutSearch::setWindow(double bottom, double length) {
  window_ = {cloth_.left, cloth_.right, bottom, bottom + length};
  domains_.clear();
  for (int placed = 0; placed < pieces_.placedCount(); ++placed)
    domains_.push_back(pieces_.domain(placed, window_, cloth_.origin));
}

float LayoutSearch::overlap(int a, int b) const {
  const LayPlace &p = places_[a], &q = places_[b];
  if (p.way < 0 || q.way < 0) return 0;
  return static_cast<float>(pieces_
                                .table(pieces_.items()[a].ways[p.way].placed,
                                       pieces_.items()[b].ways[q.way].placed)
                                .depth(q.dot - p.dot));
}

void LayoutSearch::place(int item, const LayPlace& place) {
  places_[item] = place;
  for (int other = 0; other < count_; ++other) {
    if (other == item) continue;
    const float depth = overlap(item, other);
    overlaps_[static_cast<std::size_t>(item) * count_ + other] = depth;
    overlaps_[static_cast<std::size_t>(other) * count_ + item] = depth;
  }
  float on_flaws = 0;
  if (place.way >= 0)
    for (const DifferenceTable& flaw : flaws_[pieces_.items()[item].ways[place.way].placed])
      on_flaws += static_cast<float>(flaw.depth(place.dot));
  flaw_overlaps_[item] = on_flaws;
}

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
  for (const Other& other : others) {
    const DifferenceTable& table = *other.table;
    const int row = j - other.dot.j;
    if (row < table.rows().lo || row > table.rows().hi) continue;
    const DotRun columns = table.columns();
    const int lo = std::max(run.lo, other.dot.i + columns.lo);
    const int hi = std::min(run.hi, other.dot.i + columns.hi);
    if (hi < lo) continue;
    addWeighted(table.row(row) + (lo - other.dot.i - columns.lo), hi - lo + 1, other.weight,
                scores_.data() + (lo - run.lo));
    reads_ += hi - lo + kRowReads;
  }
  reads_ += run.size() + kRowReads;
}

LayoutSearch::Found LayoutSearch::leastOverlap(int item) {
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
      const float least = leastOf(scores_);
      if (least > best.score) continue;
      if (least < best.score) ties = 0;
      const int equal = static_cast<int>(std::count(scores_.begin(), scores_.end(), least));
      ties += equal;
      if (random_.below(ties) >= equal) continue;
      int nth = equal == 1 ? 0 : random_.below(equal);
      int k = 0;
      while (scores_[k] != least || nth-- > 0) ++k;
      best = {{way, {run.lo + k, j}}, least};
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

bool LayoutSearch::layInOrder(const std::vector<int>& order) {
  for (LayPlace& place : places_) place.way = -1;
  for (const int item : order) {
    const auto found = lowest(item);
    if (!found) return false;
    places_[item] = *found;
  }
  return true;
}

/// Cuts the cloth shorter and brings what lies beyond it back; false when no height to begin at
/// leaves every piece a place.
bool LayoutSearch::begin() {
  const double most = std::max(best_->length() - kShorter, 0.0);
  const double target = std::min(most, best_->length() * (1 - shrink_));
  std::vector<double> from = beginnings_;
  const int first = random_.below(static_cast<int>(from.size()));
  std::rotate(from.begin(), from.begin() + first, from.end());
  if (random_.uniform() < 0.5) from.insert(from.begin(), beginning_);
  for (const double bottom : from) {
    setWindow(bottom, target);
    bool all = true;
    for (int item = 0; item < count_ && all; ++item) all = hasPlace(item);
    if (!all) continue;
    places_ = best_->places;
    for (int item = 0; item < count_; ++item) place(item, places_[item]);
    for (int item = 0; item < count_; ++item) {
      const int placed = pieces_.items()[item].ways[places_[item].way].placed;
      if (!domains_[placed].has(places_[item].dot)) place(item, leastOverlap(item).place);
    }
    std::fill(weights_.begin(), weights_.end(), 1.0f);
    least_total_ = std::numeric_limits<double>::infinity();
    idle_ = 0;
    is_under_way_ = true;
    return true;
  }
  return false;
}

/// Goes on from elsewhere: pieces change places, or some are taken off and laid again.
void LayoutSearch::restart() {
  idle_ = 0;
  least_total_ = std::numeric_limits<double>::infinity();
  std::fill(weights_.begin(), weights_.end(), 1.0f);
  const int few = 2 + random_.below(std::max(1, count_ / 3));
  std::vector<int> taken;
  for (int k = 0; k < few; ++k) {
    const int item = random_.below(count_);
    if (places_[item].way < 0) continue;
    place(item, {});
    taken.push_back(item);
  }
  for (const int item : taken) place(item, leastOverlap(item).place);
}

double LayoutSearch::total() const {
  double sum = 0;
  for (const float depth : overlaps_) sum += depth;
  sum /= 2;
  for (const float depth : flaw_overlaps_) sum += depth;
  return sum;
}

void LayoutSearch::sweep() {
  std::vector<int> meeting;
  const auto meets = [&](int item) {
    if (flaw_overlaps_[item] > 0) return true;
    const float* row = overlaps_.data() + static_cast<std::ptrdiff_t>(item) * count_;
    return std::any_of(row, row + count_, [](float depth) { return depth > 0; });
  };
  for (int item = 0; item < count_; ++item)
    if (meets(item)) meeting.push_back(item);
  for (std::size_t k = meeting.size(); k > 1; --k)
    std::swap(meeting[k - 1], meeting[random_.below(static_cast<int>(k))]);
  for (const int item : meeting)
    if (meets(item)) place(item, leastOverlap(item).place);
}

/// Pairs that overlap most weigh more the next time, those that do not a little less [Gardeyn and
/// Wauters 2025, Algorithm 8].
void LayoutSearch::reweigh() {
  const float most = *std::max_element(overlaps_.begin(), overlaps_.end());
  if (most <= 0) return;
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const float depth = overlaps_[k];
    weights_[k] =
        depth > 0 ? weights_[k] * (1.2f + 0.8f * depth / most) : std::max(1.0f, weights_[k] * 0.95f);
  }
}

bool LayoutSearch::improve() {
  if (!best_) return false;
  if (!is_under_way_) {
    restarts_ = 0;
    while (!begin()) {
      if (shrink_ == 0) return false;
      shrink_ = shrink_ > 2e-3 ? shrink_ / 2 : 0;
    }
  }
  sweep();
  const double left = total();
  if (left == 0) {
    LaidPieces layout{places_};
    measure(pieces_, cloth_, &layout);
    offer(layout);
    return true;
  }
  reweigh();
  idle_ = left < least_total_ ? 0 : idle_ + 1;
  least_total_ = std::min(least_total_, left);
  if (idle_ < kIdleSweeps) return true;
  if (++restarts_ < kRestarts) {
    restart();
    return true;
  }
  is_under_way_ = false;  // another height to begin at, and a target less far
  shrink_ = shrink_ > 2e-3 ? shrink_ / 2 : 0;
  return true;
}

}  // namespace seamwise
