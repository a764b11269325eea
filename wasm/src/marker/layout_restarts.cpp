// Restarts of a layout search if overlaps do not decrease.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "marker/layout_search.h"

namespace seamwise {
namespace {

constexpr int kMostTaken = 4;  ///< greatest number of pieces that are replaced at once

/// Limits before the next strategy is tried.
struct Patience {
  int sweeps;    ///< sweeps without less overlap
  int returns;   ///< returns to the least overlap, with the current weights
  int restarts;  ///< restarts before a less ambitious target
};
/// A move on a fine board is cheap and visits only a few dots. Measured on published packings.
constexpr Patience kFew{40, 0, 6}, kFine{100, 2, 3};

}  // namespace

/// Moves all pieces above the lower end of a random piece down, so that pieces overlap only there.
void LayoutSearch::closeUp(double by) {
  const int down = static_cast<int>(std::ceil(by / pieces_.board().up.y()));
  const auto bottomOf = [&](int item) {
    const int placed = pieces_.items()[item].ways[places_[item].way].placed;
    return pieces_.bottomAt(placed, places_[item].dot, fabric_.origin);
  };
  const double cut = bottomOf(random_.below(count_));
  for (int item = 0; item < count_; ++item)
    if (bottomOf(item) > cut && !pieces_.items()[item].is_pinned) places_[item].dot.j -= down;
}

/// Continues from given positions; pieces outside the window are moved back into it.
void LayoutSearch::takeUp(const std::vector<LayPlace>& places) {
  places_ = places;
  for (int item = 0; item < count_; ++item) place(item, places_[item]);
  for (int item = 0; item < count_; ++item) {
    const int placed = pieces_.items()[item].ways[places_[item].way].placed;
    if (!domains_[placed].has(places_[item].dot)) place(item, leastOverlap(item).place);
  }
}

/// Continues from other positions if overlaps have not decreased for long. Returns true when all
/// such restarts are used up.
bool LayoutSearch::isGivenUp() {
  const Patience& patience = pieces_.isFine() ? kFine : kFew;
  if (idle_ < patience.sweeps) return false;
  idle_ = 0;
  if (returns_++ < patience.returns) {
    takeUp(least_places_);
    return false;
  }
  returns_ = 0;
  if (++restarts_ >= patience.restarts) return true;
  pieces_.isFine() ? swapTwo() : restart();
  least_total_ = std::numeric_limits<double>::infinity();
  return false;
}

/// Removes some pieces and places them again.
void LayoutSearch::restart() {
  std::fill(weights_.begin(), weights_.end(), 1.0f);
  const int few = 2 + random_.below(std::clamp(count_ / 3, 1, kMostTaken));
  takeUp(least_places_);
  std::vector<int> taken;
  for (int k = 0; k < few; ++k) {
    const int item = random_.below(count_);
    if (places_[item].way < 0 || pieces_.items()[item].is_pinned) continue;
    place(item, {});
    taken.push_back(item);
  }
  for (const int item : taken) place(item, leastOverlap(item).place);
}

/// Exchanges two large pieces at the positions with the least overlap, either recent or overall.
void LayoutSearch::swapTwo() {
  if (least_total_ < least_of_target_) {
    least_of_target_ = least_total_;
    least_places_of_target_ = least_places_;
  }
  std::vector<LayPlace> places = random_.below(2) ? least_places_ : least_places_of_target_;
  std::fill(weights_.begin(), weights_.end(), 1.0f);
  const std::vector<int>& order = orders_.front();
  const int large = std::max(std::min(2, count_), count_ / 2);
  const auto placedOf = [&](int item) {
    return pieces_.items()[item].ways[places[item].way].placed;
  };
  const auto middleOf = [&](int item, Dot dot) {
    const int placed = placedOf(item);
    return Vec2(pieces_.at(placed, dot, fabric_.origin) + pieces_.shape(placed).middle());
  };
  constexpr int kTries = 20;
  for (int tried = 0; tried < kTries; ++tried) {
    const int a = order[random_.below(large)], b = order[random_.below(large)];
    if (pieces_.items()[a].is_pinned || pieces_.items()[b].is_pinned ||
        pieces_.items()[a].like == pieces_.items()[b].like)
      continue;
    const Vec2 of_a = middleOf(a, places[a].dot), of_b = middleOf(b, places[b].dot);
    const auto put = [&](int item, const Vec2& middle) {
      const Vec2 steps = pieces_.board().steps(middle - middleOf(item, {0, 0}));
      places[item].dot = {static_cast<int>(std::nearbyint(steps.x())),
                          static_cast<int>(std::nearbyint(steps.y()))};
    };
    put(a, of_b);
    put(b, of_a);
    break;
  }
  takeUp(places);
}

}  // namespace seamwise
