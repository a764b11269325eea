#include "marker/layout_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "base/sort_by.h"

namespace seamwise {
namespace {

constexpr std::size_t kMostBeginnings = 24;
constexpr std::size_t kSortedOrders = 3;  ///< orders by area, height and width
constexpr double kShorter = 0.01;         ///< least improvement by a shorter layout, cm
constexpr double kFirstShrink = 0.01, kMostShrink = 0.03, kLeastShrink = 2e-3;
/// Fine boards also get first layouts in random orders, within kShuffledReads, because the later
/// search seldom changes the arrangement of few pieces. A tee of four pieces needs 114.4 cm in each
/// sorted order and 93.9 cm with these.
constexpr std::size_t kRoundsOfOrders = 9;  ///< rounds of orders, of which the first is sorted
constexpr double kShuffledReads = 1e8;
constexpr int kDoublings = 8;       ///< greatest number of doublings of the window's height
constexpr float kMostWeight = 1e9;  ///< keeps sums of weighted depths finite
constexpr double kMuchLess = 0.98;  ///< share of the least overlap so far

}  // namespace

LayoutSearch::LayoutSearch(const PiecesOnBoard& pieces, LayFabric fabric, std::uint64_t seed)
    : pieces_(pieces),
      fabric_(std::move(fabric)),
      random_(seed),
      count_(static_cast<int>(pieces.items().size())),
      ways_(allowedWays(pieces, fabric_)),
      flaws_(pieces.placedCount()),
      beginnings_(beginnings(pieces, fabric_, kMostBeginnings)),
      shrink_(pieces.isFine() ? kFirstShrink : 0) {
  for (int placed = 0; placed < pieces.placedCount(); ++placed)
    flaws_[placed] = pieces.flawTables(placed, fabric_.origin);
  places_.resize(count_);
  weights_.assign(static_cast<std::size_t>(count_) * count_, 1);
  overlaps_.assign(weights_.size(), 0);
  flaw_overlaps_.assign(count_, 0);
  std::vector<int> order(count_);
  std::iota(order.begin(), order.end(), 0);
  const auto size = [&](int item, std::size_t by) -> double {
    if (ways_[item].empty()) return 0;
    const Shape& shape = pieces.shapeOf(pieces.items()[item].ways[ways_[item].front()]);
    const Vec2 box = shape.high - shape.low;
    return by == 0 ? shape.area : by == 1 ? box.y() : box.x();
  };
  for (std::size_t by = 0; by < kSortedOrders; ++by) {
    // Pinned pieces come first, then the largest.
    sortBy(order,
           [&](int item) { return pieces.items()[item].is_pinned ? -1e9 : -size(item, by); });
    orders_.push_back(order);
  }
}

void LayoutSearch::shuffle(std::vector<int>* items) {
  for (int k = static_cast<int>(items->size()); k > 1; --k)
    std::swap((*items)[k - 1], (*items)[random_.below(k)]);
}

bool LayoutSearch::construct() {
  const bool is_fine = pieces_.isFine();
  if (next_ == orders_.size() * (is_fine ? kRoundsOfOrders : beginnings_.size()) || homeless_ >= 0)
    return false;
  const bool is_shuffled = is_fine && next_ >= orders_.size();
  std::vector<int>& order = is_shuffled ? orders_.back() : orders_[next_ % orders_.size()];
  if (laid_ == 0) {
    if (is_shuffled) {
      // Pinned pieces must be placed first.
      if (reads_ > kShuffledReads || pieces_.items()[order.front()].is_pinned) return false;
      shuffle(&order);
    }
    if (doublings_ == 0) height_ = firstHeight();
    setWindow(beginnings_[next_ / orders_.size() % beginnings_.size()], height_);
    for (LayPlace& place : places_) place.way = -1;
  }
  const int item = order[laid_];
  if (const auto found = lowest(item)) {
    places_[item] = *found;
    if (++laid_ < order.size()) return true;
    LaidPieces layout{places_};
    measure(pieces_, fabric_, &layout);
    offer(layout);
  } else {
    laid_ = 0;
    // If rows repeat, taller windows have the same rows as this one, but may contain a pin.
    const bool is_hopeless =
        !hasPlace(item) && !pieces_.items()[item].is_pinned && (doublings_ > 0 || pieces_.period());
    height_ *= 2;
    if (!is_hopeless && ++doublings_ < kDoublings) return true;
    homeless_ = item;
    return false;
  }
  laid_ = 0;
  doublings_ = 0;
  ++next_;
  return true;
}

/// Window height for a loose layout; construct() doubles it if necessary. [cm]
double LayoutSearch::firstHeight() const {
  double tallest = 0;
  for (int placed = 0; placed < pieces_.placedCount(); ++placed)
    tallest = std::max(tallest, pieces_.shape(placed).high.y() - pieces_.shape(placed).low.y());
  constexpr double kUnknownRepeat = 100;
  const double repeat = pieces_.period().value_or(kUnknownRepeat);
  const double width = std::max(fabric_.right - fabric_.left, 1.0);
  return 2 * (pieces_.area() / width + tallest + repeat);
}

void LayoutSearch::offer(const LaidPieces& layout) {
  if (best_ && layout.length() > best_->length() - kShorter / 2) return;  // tolerates rounding
  best_ = layout;
  beginning_ = fabric_.is_fixed ? 0 : layout.bottom;
  is_under_way_ = false;
}

bool LayoutSearch::hasPlace(int item) const {
  return std::any_of(ways_[item].begin(), ways_[item].end(), [&](int way) {
    return !domains_[pieces_.items()[item].ways[way].placed].empty();
  });
}

void LayoutSearch::setWindow(double bottom, double length) {
  window_ = {fabric_.left, fabric_.right, bottom, bottom + length};
  domains_ = std::vector<Domain>(pieces_.placedCount());
  for (int placed = 0; placed < pieces_.placedCount(); ++placed)
    domains_[placed] = pieces_.domain(placed, window_, fabric_.origin);
}

float LayoutSearch::overlap(int a, int b) const {
  const LayPlace &p = places_[a], &q = places_[b];
  if (p.way < 0 || q.way < 0) return 0;
  return static_cast<float>(
      pieces_.table(pieces_.items()[a].ways[p.way].placed, pieces_.items()[b].ways[q.way].placed)
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

/// Shortens the fabric and moves pieces outside back into it. Returns false if at every start
/// height some piece does not fit.
bool LayoutSearch::begin() {
  const double most = std::max(best_->length() - kShorter, 0.0);
  const double target = std::min(most, best_->length() * (1 - shrink_));
  const std::size_t count = beginnings_.size();
  const std::size_t first = random_.below(static_cast<int>(count));
  // Try the start height of the best layout first with a probability of one half.
  const std::size_t before = random_.uniform() < 0.5 ? 1 : 0;
  for (std::size_t k = 0; k < count + before; ++k) {
    const double bottom = k < before ? beginning_ : beginnings_[(first + k - before) % count];
    setWindow(bottom, target);
    bool all = true;
    for (int item = 0; item < count_ && all; ++item) all = hasPlace(item);
    if (!all) continue;
    places_ = best_->places;
    if (pieces_.isFine()) closeUp(best_->length() - target);
    takeUp(places_);
    std::fill(weights_.begin(), weights_.end(), 1.0f);
    least_total_ = least_of_target_ = std::numeric_limits<double>::infinity();
    idle_ = returns_ = 0;
    is_under_way_ = true;
    return true;
  }
  return false;
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
  shuffle(&meeting);
  for (const int item : meeting)
    if (meets(item)) place(item, leastOverlap(item).place);
}

/// Increases the weights of overlapping pairs by their depth and slightly decreases the others
/// [Gardeyn and Wauters 2025, Algorithm 8].
void LayoutSearch::reweigh() {
  const float most = *std::max_element(overlaps_.begin(), overlaps_.end());
  if (most <= 0) return;
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const float depth = overlaps_[k];
    weights_[k] = depth > 0 ? std::min(kMostWeight, weights_[k] * (1.2f + 0.8f * depth / most))
                            : std::max(1.0f, weights_[k] * 0.95f);
  }
}

/// Halves the reduction of the next target; the last target is any shorter length.
void LayoutSearch::shrinkLess() { shrink_ = shrink_ > kLeastShrink ? shrink_ / 2 : 0; }

bool LayoutSearch::improve() {
  if (!best_) return false;
  if (!is_under_way_) {
    restarts_ = 0;
    while (!begin()) {
      if (shrink_ == 0) return false;
      shrinkLess();
    }
  }
  sweep();
  const double left = total();
  if (left == 0) {
    if (restarts_ == 0) shrink_ = std::min(kMostShrink, 1.5 * shrink_);
    LaidPieces layout{places_};
    measure(pieces_, fabric_, &layout);
    offer(layout);
    return true;
  }
  reweigh();
  ++idle_;
  if (left < least_total_) {
    idle_ = 0;
    if (left < kMuchLess * least_total_) returns_ = 0;
    least_total_ = left;
    least_places_ = places_;
  }
  if (!isGivenUp()) return true;
  is_under_way_ = false;  // continue with another start height and a less ambitious target
  shrinkLess();
  return true;
}

}  // namespace seamwise
