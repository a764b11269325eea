// Setup of a complete search. It takes little time, so it may be compiled for size.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/sort_by.h"
#include "marker/complete_search.h"

namespace seamwise {
namespace {

constexpr double kSameHeight = 1e-6;  // cm

}  // namespace

CompleteSearch::CompleteSearch(const PiecesOnBoard& pieces, const LayFabric& fabric, double length)
    : pieces_(pieces), fabric_(fabric), length_(length) {
  const bool is_level = pieces.board().along.y() == 0;
  if (pieces.isFine() || !pieces.isWhole() || !is_level || !(pieces.period() || fabric.is_fixed))
    return;
  // The tallest piece starts within one repeat. Its position limits the others through pairs.
  const double repeat = fabric.is_fixed ? 0 : *pieces.period();
  const double below = fabric.is_fixed ? 0 : length;
  can_prove_ = setSlots({fabric.left, fabric.right, -below, repeat + length});
  if (!can_prove_) return;
  bits_.resize(static_cast<std::size_t>(pieces.placedCount()) * pieces.placedCount());
  places_.resize(slots_.of.size());
  failures_.assign(slots_.of.size(), 1);
  levels_.resize(slots_.of.size());
  order_ = likely_ = tallestFirst();
  begin();
}

/// Collects the ways of all items in a window. Returns false if a row of dots does not fit into a
/// word.
bool CompleteSearch::setSlots(const Window& window) {
  const double up = pieces_.board().up.y();
  const auto ways = allowedWays(pieces_, fabric_);
  slots_.of.resize(ways.size());
  for (std::size_t item = 0; item < ways.size(); ++item) {
    for (const int way : ways[item]) {
      const int placed = pieces_.items()[item].ways[way].placed;
      SearchSlot slot;
      slot.item = static_cast<int>(item);
      slot.way = way;
      slot.placed = placed;
      slot.low = pieces_.bottomAt(placed, {0, 0}, fabric_.origin);
      slot.high = pieces_.topAt(placed, {0, 0}, fabric_.origin);
      slot.middle =
          pieces_.at(placed, {0, 0}, fabric_.origin).x() + pieces_.shape(placed).middle().x();
      slot.domain = pieces_.domain(placed, window, fabric_.origin);
      slot.row0 = static_cast<std::ptrdiff_t>(dots_.size()) - slot.domain.first;
      const auto flaws = pieces_.flawTables(placed, fabric_.origin);
      for (int j = slot.domain.first; j <= slot.domain.rows().hi; ++j) {
        const DotRun& run = slot.domain.row(j);
        if (run.size() > kBits) return false;
        std::uint64_t bits = 0;
        for (int i = run.lo; i <= run.hi; ++i) {
          const bool is_flawed =
              std::any_of(flaws.begin(), flaws.end(), [&](const DifferenceTable& flaw) {
                return flaw.depth({i, j}) > 0;
              });
          if (!is_flawed) bits |= std::uint64_t{1} << (i - run.lo);
        }
        dots_.push_back(bits);
      }
      slots_.of[item].push_back(static_cast<int>(slots_.slots.size()));
      slots_.slots.push_back(std::move(slot));
    }
  }
  for (const SearchSlot& from : slots_.slots)
    for (const SearchSlot& to : slots_.slots)
      slots_.reaches.push_back(
          {static_cast<int>(std::ceil((from.high - length_ - to.low - kSameHeight) / up)),
           static_cast<int>(std::floor((from.low + length_ - to.high + kSameHeight) / up))});
  return true;
}

std::vector<int> CompleteSearch::tallestFirst() const {
  std::vector<double> keys;
  for (const std::vector<int>& slots : slots_.of) {
    double least = std::numeric_limits<double>::infinity();
    for (const int s : slots) least = std::min(least, slots_.slots[s].high - slots_.slots[s].low);
    keys.push_back(-least);
  }
  std::vector<int> order;
  for (const std::size_t item : placesInOrder(keys)) order.push_back(static_cast<int>(item));
  return order;
}

void CompleteSearch::begin() {
  Level& level = levels_.front();
  level.left.bits = dots_;
  level.counts.assign(places_.size(), 0);
  for (std::size_t s = 0; s < slots_.slots.size(); ++s) {
    const SearchSlot& slot = slots_.slots[s];
    const bool is_in = slot.high - slot.low < length_ + kSameHeight;
    level.left.rows.push_back(is_in ? slot.domain.rows() : DotRun{});
    DotRun& rows = level.left.rows.back();
    if (!fabric_.is_fixed && slot.item == order_.front()) {
      const double up = pieces_.board().up.y();
      const auto rowFrom = [&](double height) {
        return static_cast<int>(std::ceil((height - kSameHeight - slot.low) / up));
      };
      rows = {std::max(rows.lo, rowFrom(0)), std::min(rows.hi, rowFrom(*pieces_.period()) - 1)};
    }
    for (int j = rows.lo; j <= rows.hi; ++j)
      level.counts[slot.item] += std::popcount(level.left.bits[slot.row0 + j]);
  }
  if (std::any_of(level.counts.begin(), level.counts.end(), [](int n) { return n == 0; })) return;
  tall_.emplace(pieces_, slots_, order_, length_);
  depth_ = 1;
  if (!fabric_.is_fixed)
    setValues(&level, order_.front(), 0);
  else if (!setNext(&level, nullptr))
    depth_ = 0;
}

}  // namespace seamwise
