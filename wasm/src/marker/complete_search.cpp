#include "marker/complete_search.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

namespace seamwise {

std::uint64_t CompleteSearch::BitTable::window(int row, int start) const {
  const int from = start + kBits;
  if (from <= 0 || from >= (words - 1) * kBits) return 0;
  const std::uint64_t* word =
      bits.data() + static_cast<std::ptrdiff_t>(row - rows.lo) * words + from / kBits;
  const int off = from % kBits;
  return word[0] >> off | word[1] << 1 << (kBits - 1 - off);
}

const CompleteSearch::BitTable& CompleteSearch::bitsOf(int first, int second) {
  BitTable& bits = bits_[static_cast<std::size_t>(first) * pieces_.placedCount() + second];
  const DifferenceTable& table = pieces_.table(first, second);
  if (bits.words > 0 || table.empty()) return bits;
  const DotRun columns = table.columns();
  bits.rows = table.rows();
  bits.column = columns.lo;
  bits.words = (columns.size() + kBits - 1) / kBits + 2;
  bits.bits.resize(static_cast<std::size_t>(bits.words) * bits.rows.size());
  for (int j = bits.rows.lo; j <= bits.rows.hi; ++j)
    for (int k = 0; k < columns.size(); ++k)
      if (table.depth({columns.lo + k, j}) > 0)
        bits.bits[static_cast<std::size_t>(j - bits.rows.lo) * bits.words + 1 + k / kBits] |=
            std::uint64_t{1} << (k % kBits);
  return bits;
}

/// Sets the values of a level to all dots of a piece.
/// @param order   set of the pieces already placed side by side
void CompleteSearch::setValues(Level* level, int item, unsigned order) const {
  level->values.clear();
  level->next = 0;
  level->is_of_one = true;
  for (const int s : slots_.of[item]) {
    const SearchSlot& slot = slots_.slots[s];
    for (int j = level->left.rows[s].lo; j <= level->left.rows[s].hi; ++j)
      for (std::uint64_t bits = level->left.bits[slot.row0 + j]; bits != 0; bits &= bits - 1) {
        const SlotDot value{s, {slot.column(j) + std::countr_zero(bits), j}, order};
        level->values.push_back(value);
      }
  }
}

/// Sets the values of a level. Returns false if the pieces side by side do not fit.
/// @param last   the last placed one of these; null before the first
bool CompleteSearch::setNext(Level* level, const SlotDot* last) {
  // If the cut is not fixed, the tallest piece is placed before the others side by side.
  const unsigned laid = fabric_.is_fixed ? 0 : 1;
  const unsigned order = last == nullptr ? 0 : last->order;
  if (tall_->empty() || (order | laid) == tall_->all()) {
    setValues(level, nextItem(*level), tall_->all());
    return true;
  }
  if (last == nullptr && !tall_->setLimits(level->left, &reads_)) return false;
  level->values.clear();
  level->next = 0;
  level->is_of_one = false;
  tall_->addNext(level->left, last, laid, &level->values);
  return true;
}

/// The next item to place: the one with the fewest dots per number of its failures.
int CompleteSearch::nextItem(const Level& level) const {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t item = 0; item < places_.size(); ++item) {
    if (places_[item].way >= 0 || level.counts[item] / failures_[item] >= least) continue;
    least = level.counts[item] / failures_[item];
    best = static_cast<int>(item);
  }
  return best;
}

/// Removes a dot from an item and its equals, because every layout with the item there has been
/// visited.
void CompleteSearch::removeLike(Level* level, const SlotDot& value) const {
  const SearchSlot& at = slots_.slots[value.slot];
  const int like = pieces_.items()[at.item].like;
  const std::uint64_t bit = std::uint64_t{1} << (value.dot.i - at.column(value.dot.j));
  for (const SearchSlot& slot : slots_.slots)
    if (pieces_.items()[slot.item].like == like && slot.placed == at.placed)
      level->left.bits[slot.row0 + value.dot.j] &= ~bit;
}

/// True if both ways are compatible with the same direction for all pieces of one garment.
bool CompleteSearch::mayPoint(const SearchSlot& slot, const SearchSlot& other) const {
  const LayItem &a = pieces_.items()[slot.item], &b = pieces_.items()[other.item];
  return !fabric_.is_by_garment || a.garment != b.garment ||
         a.ways[slot.way].is_up == b.ways[other.way].is_up;
}

/// Removes from an item the dots that a placed piece covers and those too far from it. Returns
/// false if none is left.
bool CompleteSearch::leaves(Level* level, const SlotDot& value, int item) {
  const SearchSlot& at = slots_.slots[value.slot];
  int count = 0;
  for (const int s : slots_.of[item]) {
    const SearchSlot& slot = slots_.slots[s];
    const BitTable& table = bitsOf(at.placed, slot.placed);
    const DotRun& reach = slots_.reach(value.slot, s);
    DotRun& in = level->left.rows[s];
    in = {std::max(in.lo, value.dot.j + reach.lo), std::min(in.hi, value.dot.j + reach.hi)};
    if (!mayPoint(at, slot)) in = {};
    std::uint64_t* rows = level->left.bits.data() + slot.row0;
    reads_ += in.size();
    for (int j = in.lo; j <= in.hi; ++j) {
      if (rows[j] == 0) continue;
      const int of = j - value.dot.j;
      if (of >= table.rows.lo && of <= table.rows.hi)
        rows[j] &= ~table.window(of, slot.column(j) - value.dot.i - table.column);
      count += std::popcount(rows[j]);
    }
  }
  level->counts[item] = count;
  return count > 0;
}

/// Places a piece and goes one level down, unless that leaves some piece without a dot.
void CompleteSearch::place(const SlotDot& value) {
  const SearchSlot& at = slots_.slots[value.slot];
  places_[at.item] = {at.way, value.dot};
  if (depth_ == levels_.size()) {
    LaidPieces layout{places_};
    measure(pieces_, fabric_, &layout);
    found_ = layout;
    return;
  }
  Level& next = levels_[depth_];
  next.left = levels_[depth_ - 1].left;
  next.counts = levels_[depth_ - 1].counts;
  for (auto item = likely_.begin(); item != likely_.end(); ++item) {
    if (places_[*item].way >= 0 || leaves(&next, value, *item)) continue;
    ++failures_[*item];
    std::rotate(likely_.begin(), item, item + 1);
    return;
  }
  for (const int s : slots_.of[at.item]) next.left.rows[s] = {};
  next.left.rows[value.slot] = {value.dot.j, value.dot.j};
  next.left.bits[at.row0 + value.dot.j] = std::uint64_t{1}
                                          << (value.dot.i - at.column(value.dot.j));
  if (setNext(&next, value.order != 0 ? &value : nullptr)) ++depth_;
}

bool CompleteSearch::step(double reads) {
  const double end = reads_ + reads;
  while (reads_ < end && !found_) {
    if (depth_ == 0) return false;
    reads_ += 1;
    Level& level = levels_[depth_ - 1];
    if (level.next > 0) {
      const SlotDot& tried = level.values[level.next - 1];
      places_[slots_.slots[tried.slot].item] = {};
      if (level.is_of_one) removeLike(&level, tried);
    }
    if (level.next == level.values.size())
      --depth_;
    else
      place(level.values[level.next++]);
  }
  return !found_;
}

}  // namespace seamwise
