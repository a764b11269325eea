#include "nesting/layout_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>

#include "base/lanes.h"
#include "base/sort_by.h"

namespace seamwise {
namespace {

constexpr std::size_t kMostBeginnings = 24;
constexpr double kShorter = 0.01;    ///< cm by which a shorter layout is shorter at least
constexpr double kFirstShrink = 0.01, kMostShrink = 0.03;
constexpr float kFlawWeight = 1000;  ///< nothing is worth lying on a flaw
constexpr int kMostTaken = 4;        ///< pieces that are laid again at once
constexpr int kIdleSweeps = 40;      ///< without less overlap, before something else is tried
constexpr int kRowReads = 30;        ///< what beginning a row takes, in reads; measured
constexpr std::size_t kDescents = 6; ///< from the best dots that were looked at
constexpr int kRestarts = 6;         ///< before a target less far is

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
    // largest first; what is pinned is there already
    sortBy(order, [&](int item) { return -size(item, by); });
    sortBy(order, [&](int item) { return pieces.items()[item].is_pinned ? 0 : 1; });
    orders_.push_back(order);
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
    // longer windows have rows like those of this one, but a pin may lie beyond it
    const bool is_pin = homeless_ >= 0 && pieces_.items()[homeless_].is_pinned;
    if (homeless_ >= 0 && !is_pin && (times > 0 || pieces_.period())) return false;
    homeless_ = -1;
  }
  for (int item = 0; item < count_ && homeless_ < 0; ++item)
    if (places_[item].way < 0) homeless_ = item;
  return false;
}

void LayoutSearch::offer(const LaidPieces& layout) {
  if (best_ && layout.length() > best_->length() - kShorter / 2) return;
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
  DotRun box{std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
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
  reads_ += 2 * static_cast<double>(others.size());
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
  if (best.place.way >= 0) return best;
  // domains lie between the dots that are looked at
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
    if (pieces_.isFine()) closeUp(best_->length() - target);
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

/// Moves all that lies above some piece's lower end down, so that pieces overlap only there.
void LayoutSearch::closeUp(double by) {
  const int down = static_cast<int>(std::ceil(by / pieces_.board().up.y()));
  const auto bottomOf = [&](int item) {
    const int placed = pieces_.items()[item].ways[places_[item].way].placed;
    return pieces_.bottomAt(placed, places_[item].dot, cloth_.origin);
  };
  const double cut = bottomOf(random_.below(count_));
  for (int item = 0; item < count_; ++item)
    if (bottomOf(item) > cut && !pieces_.items()[item].is_pinned) places_[item].dot.j -= down;
}

/// Goes on from elsewhere: pieces change places, or some are taken off and laid again.
void LayoutSearch::restart() {
  idle_ = 0;
  least_total_ = std::numeric_limits<double>::infinity();
  std::fill(weights_.begin(), weights_.end(), 1.0f);
  const int few = 2 + random_.below(std::clamp(count_ / 3, 1, kMostTaken));
  places_ = least_places_;
  for (int item = 0; item < count_; ++item) place(item, places_[item]);
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
    if (restarts_ == 0) shrink_ = std::min(kMostShrink, 1.5 * shrink_);
    LaidPieces layout{places_};
    measure(pieces_, cloth_, &layout);
    offer(layout);
    return true;
  }
  reweigh();
  ++idle_;
  if (left < least_total_) {
    idle_ = 0;
    least_total_ = left;
    least_places_ = places_;
  }
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
