#include "marker/tall_pieces.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace seamwise {
namespace {

constexpr std::size_t kMostTall = 8, kFewestTall = 3;  ///< pieces; the number of sets is large
constexpr double kAbove = 1e-3;        ///< least excess of two heights over the length, cm
constexpr double kSameMiddle = 1e-6;   // cm
constexpr int kNoColumn = -(1 << 28);  ///< marks a missing column
constexpr double kReadsOfRun = 2;      ///< cost of a run of rows, in reads

}  // namespace

TallPieces::TallPieces(const PiecesOnBoard& pieces, const SearchSlots& slots,
                       const std::vector<int>& order, double length)
    : pieces_(pieces), slots_(slots) {
  const auto height = [&](int item) {
    double least = length;
    for (const int s : slots.of[item])
      least = std::min(least, slots.slots[s].high - slots.slots[s].low);
    return least;
  };
  for (const int item : order) {
    const bool is_tall = items_.empty() || height(items_.back()) + height(item) > length + kAbove;
    if (!is_tall || items_.size() == kMostTall) break;
    // The first of equal pieces is to the left of the others.
    unsigned before = 0;
    for (std::size_t k = 0; k < items_.size(); ++k)
      if (pieces.items()[items_[k]].like == pieces.items()[item].like) before |= 1U << k;
    items_.push_back(item);
    before_.push_back(before);
  }
  if (items_.size() < kFewestTall) items_.clear();
  least_.resize(slots.reaches.size());
  for (const int a : items_) {
    for (const int b : items_) {
      if (a == b) continue;
      for (const int from : slots.of[a]) {
        for (const int to : slots.of[b]) {
          const DotRun& reach = slots.reach(from, to);
          for (int j = reach.lo; j <= reach.hi; ++j)
            least_[slots.pair(from, to)].push_back(leastColumns(from, to, j));
        }
      }
    }
  }
}

/// Least column distance of two slots with the given difference of rows if the second's middle is
/// to the right of the first's.
int TallPieces::leastColumns(int from, int to, int row) const {
  const SearchSlot &a = slots_.slots[from], &b = slots_.slots[to];
  const Board& board = pieces_.board();
  const double apart = b.middle - a.middle + row * board.up.x();
  const DifferenceTable& table = pieces_.table(a.placed, b.placed);
  Dot dot{static_cast<int>(std::ceil((-kSameMiddle - apart) / board.along.x())), row};
  while (table.depth(dot) > 0) ++dot.i;
  return dot.i;
}

/// Last column with a dot in a row, up to a limit.
int TallPieces::lastColumn(const DotsLeft& left, int slot, int row, int limit) const {
  const SearchSlot& at = slots_.slots[slot];
  std::uint64_t bits = left.bits[at.row0 + row];
  const int last = limit - at.column(row);
  if (last < 0) return kNoColumn;
  if (last < 63) bits &= (std::uint64_t{2} << last) - 1;
  return bits == 0 ? kNoColumn : at.column(row) + std::bit_width(bits) - 1;
}

int TallPieces::limitOf(unsigned set, const DotsLeft& left, int slot, int row,
                        double* reads) const {
  int limit = kNoColumn;
  for (std::size_t k = 0; k < items_.size(); ++k) {
    if ((set >> k & 1) == 0) continue;
    for (const int next : slots_.of[items_[k]]) {
      const DotRun& reach = slots_.reach(slot, next);
      const int lo = std::max(left.rows[next].lo, row + reach.lo);
      const int hi = std::min(left.rows[next].hi, row + reach.hi);
      const std::ptrdiff_t row0 = slots_.slots[next].row0;
      const int* limits = limits_.data() + (set ^ 1U << k) * left.bits.size();
      const int* least = least_[slots_.pair(slot, next)].data();
      for (int j = lo; j <= hi; ++j)
        limit = std::max(limit, limits[row0 + j] - least[j - row - reach.lo]);
      *reads += kReadsOfRun;
    }
  }
  return limit;
}

bool TallPieces::setLimits(const DotsLeft& left, double* reads) {
  limits_.assign(left.bits.size() << items_.size(), kNoColumn);
  bool any = false;
  for (unsigned set = 0; set < all(); ++set) {
    for (std::size_t k = 0; k < items_.size(); ++k) {
      if (set >> k & 1) continue;
      for (const int s : slots_.of[items_[k]]) {
        for (int j = left.rows[s].lo; j <= left.rows[s].hi; ++j) {
          const int limit = set == 0 ? -kNoColumn : limitOf(set, left, s, j, reads);
          const int last = lastColumn(left, s, j, limit);
          limits_[set * left.bits.size() + slots_.slots[s].row0 + j] = last;
          any = any || (last != kNoColumn && (set | 1U << k) == all());
        }
      }
    }
  }
  return any;
}

void TallPieces::addNext(const DotsLeft& left, const SlotDot* last, unsigned laid,
                         std::vector<SlotDot>* next) const {
  const unsigned order = last == nullptr ? 0 : last->order;
  for (std::size_t k = 0; k < items_.size(); ++k) {
    const unsigned bit = 1U << k, rest = all() & ~(order | bit);
    if ((order & bit) != 0 || (before_[k] & ~(order | laid)) != 0) continue;
    const bool is_laid = (laid & bit) != 0;
    if (is_laid && rest == 0) continue;
    for (const int s : slots_.of[items_[k]]) {
      const SearchSlot& slot = slots_.slots[s];
      DotRun rows = left.rows[s];
      if (last != nullptr) {
        const DotRun& reach = slots_.reach(last->slot, s);
        rows = {std::max(rows.lo, last->dot.j + reach.lo),
                std::min(rows.hi, last->dot.j + reach.hi)};
      }
      for (int j = rows.lo; j <= rows.hi; ++j) {
        const int to = limits_[rest * left.bits.size() + slot.row0 + j];
        int from = kNoColumn;
        if (last != nullptr) {
          const int row = j - last->dot.j - slots_.reach(last->slot, s).lo;
          from = last->dot.i + least_[slots_.pair(last->slot, s)][row];
        }
        for (std::uint64_t bits = left.bits[slot.row0 + j]; bits != 0; bits &= bits - 1) {
          const SlotDot at{s, {slot.column(j) + std::countr_zero(bits), j}, order | bit};
          if (at.dot.i < from || at.dot.i > to) continue;
          if (is_laid)
            addNext(left, &at, laid, next);
          else
            next->push_back(at);
        }
      }
    }
  }
}

}  // namespace seamwise
