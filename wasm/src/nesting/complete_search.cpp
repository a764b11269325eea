#include "nesting/complete_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace seamwise {
namespace {

constexpr int kBits = 64;
constexpr double kSameHeight = 1e-6;  // cm

}  // namespace

CompleteSearch::CompleteSearch(const PiecesOnBoard& pieces, const LayCloth& cloth, double length)
    : pieces_(pieces), cloth_(cloth), length_(length) {
  const bool is_level = pieces.board().along.y() == 0;
  if (pieces.isFine() || !pieces.isWhole() || !is_level || !(pieces.period() || cloth.is_fixed))
    return;
  const auto ways = allowedWays(pieces, cloth);
  slots_of_.resize(ways.size());
  int tallest = 0;
  double height = 0;
  for (std::size_t item = 0; item < ways.size(); ++item) {
    for (const int way : ways[item]) {
      const int placed = pieces.items()[item].ways[way].placed;
      const double low = pieces.bottomAt(placed, {0, 0}, cloth.origin);
      const double high = pieces.topAt(placed, {0, 0}, cloth.origin);
      slots_of_[item].push_back(static_cast<int>(slots_.size()));
      slots_.push_back({static_cast<int>(item), way, placed, low, high});
      if (high - low <= height) continue;
      height = high - low;
      tallest = static_cast<int>(item);
    }
  }
  bits_.resize(static_cast<std::size_t>(pieces.placedCount()) * pieces.placedCount());
  places_.resize(ways.size());
  failures_.assign(ways.size(), 1);
  // the tallest piece begins within one repeat; where it lies limits the others by pairs alone
  const double repeat = cloth.is_fixed ? 0 : *pieces.period();
  const Window window = cloth.is_fixed ? Window{cloth.left, cloth.right, 0, length}
                                       : Window{cloth.left, cloth.right, -length, repeat + length};
  can_prove_ = setRows(window);
  if (!can_prove_ || rows_.empty()) return;
  Level level = root(window);
  const int first = cloth.is_fixed ? nextItem(level) : tallest;
  if (first < 0) return;
  for (const Value& value : valuesOf(level, first)) {
    const double bottom = slots_[value.slot].low + value.dot.j * pieces.board().up.y();
    if (cloth.is_fixed || (bottom > -kSameHeight && bottom < repeat - kSameHeight))
      level.values.push_back(value);
  }
  levels_.push_back(std::move(level));
}

/// The rows of a window and the domains in it; false when a row does not go into a word.
bool CompleteSearch::setRows(const Window& window) {
  rows_ = {std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
  for (const Slot& slot : slots_) {
    domains_.push_back(pieces_.domain(slot.placed, window, cloth_.origin));
    if (domains_.back().runs.empty()) continue;
    rows_.lo = std::min(rows_.lo, domains_.back().rows().lo);
    rows_.hi = std::max(rows_.hi, domains_.back().rows().hi);
  }
  if (rows_.empty()) return true;
  bases_.assign(rows_.size(), std::numeric_limits<int>::max());
  std::vector<int> ends(rows_.size(), std::numeric_limits<int>::min());
  for (const Domain& domain : domains_) {
    for (int j = domain.first; j <= domain.rows().hi; ++j) {
      if (domain.row(j).empty()) continue;
      bases_[j - rows_.lo] = std::min(bases_[j - rows_.lo], domain.row(j).lo);
      ends[j - rows_.lo] = std::max(ends[j - rows_.lo], domain.row(j).hi);
    }
  }
  for (int j = 0; j < rows_.size(); ++j)
    if (ends[j] >= bases_[j] && ends[j] - bases_[j] >= kBits) return false;
  return true;
}

CompleteSearch::Level CompleteSearch::root(const Window& window) const {
  Level level;
  level.domains.assign(slots_.size() * rows_.size(), 0);
  level.bottom = window.bottom;
  level.top = window.top;
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    if (slots_[s].high - slots_[s].low > length_ + kSameHeight) continue;
    const auto flaws = pieces_.flawTables(slots_[s].placed, cloth_.origin);
    for (int j = domains_[s].first; j <= domains_[s].rows().hi; ++j) {
      const DotRun& run = domains_[s].row(j);
      for (int i = run.lo; i <= run.hi; ++i) {
        const bool is_flawed =
            std::any_of(flaws.begin(), flaws.end(), [&](const DifferenceTable& flaw) {
              return flaw.depth({i, j}) > 0;
            });
        if (!is_flawed)
          level.domains[rowAt(static_cast<int>(s), j)] |= std::uint64_t{1}
                                                          << (i - bases_[j - rows_.lo]);
      }
    }
  }
  return level;
}

std::uint64_t CompleteSearch::BitTable::window(int row, int start) const {
  const std::uint64_t* words_of = bits.data() + static_cast<std::ptrdiff_t>(row - rows.lo) * words;
  const auto word = [&](int k) { return k >= 0 && k < words ? words_of[k] : 0; };
  const int first = start >= 0 ? start / kBits : -((kBits - 1 - start) / kBits);
  const int off = start - first * kBits;
  return off == 0 ? word(first) : word(first) >> off | word(first + 1) << (kBits - off);
}

const CompleteSearch::BitTable& CompleteSearch::bitsOf(int first, int second) {
  BitTable& bits = bits_[static_cast<std::size_t>(first) * pieces_.placedCount() + second];
  const DifferenceTable& table = pieces_.table(first, second);
  if (bits.words > 0 || table.empty()) return bits;
  const DotRun columns = table.columns();
  bits.rows = table.rows();
  bits.column = columns.lo;
  bits.words = (columns.size() + kBits - 1) / kBits;
  bits.bits.resize(static_cast<std::size_t>(bits.words) * bits.rows.size());
  for (int j = bits.rows.lo; j <= bits.rows.hi; ++j)
    for (int k = 0; k < columns.size(); ++k)
      if (table.depth({columns.lo + k, j}) > 0)
        bits.bits[static_cast<std::size_t>(j - bits.rows.lo) * bits.words + k / kBits] |=
            std::uint64_t{1} << (k % kBits);
  return bits;
}

std::vector<CompleteSearch::Value> CompleteSearch::valuesOf(const Level& level, int item) const {
  std::vector<Value> values;
  for (int j = rows_.lo; j <= rows_.hi; ++j) {
    for (const int slot : slots_of_[item]) {
      for (std::uint64_t bits = level.domains[rowAt(slot, j)]; bits != 0; bits &= bits - 1)
        values.push_back({item, slot, {bases_[j - rows_.lo] + std::countr_zero(bits), j}});
    }
  }
  return values;
}

int CompleteSearch::dotsOf(const Level& level, int item) const {
  int count = 0;
  for (const int slot : slots_of_[item]) {
    const std::uint64_t* rows = level.domains.data() + rowAt(slot, rows_.lo);
    for (int j = 0; j < rows_.size(); ++j) count += std::popcount(rows[j]);
  }
  return count;
}

/// The item to be placed next: that with the fewest dots by how often it ran out of them; -1 when
/// one has none.
int CompleteSearch::nextItem(const Level& level) const {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t item = 0; item < places_.size(); ++item) {
    if (places_[item].way >= 0) continue;
    const int count = dotsOf(level, static_cast<int>(item));
    if (count == 0) return -1;
    if (count / failures_[item] >= least) continue;
    least = count / failures_[item];
    best = static_cast<int>(item);
  }
  return best;
}

/// Every layout with the item there has been looked at, and so with an equal item.
void CompleteSearch::removeLike(Level* level, const Value& value) const {
  const int like = pieces_.items()[value.item].like;
  const std::uint64_t bit = std::uint64_t{1} << (value.dot.i - bases_[value.dot.j - rows_.lo]);
  for (std::size_t s = 0; s < slots_.size(); ++s)
    if (pieces_.items()[slots_[s].item].like == like &&
        slots_[s].placed == slots_[value.slot].placed)
      level->domains[rowAt(static_cast<int>(s), value.dot.j)] &= ~bit;
}

/// Takes from an item the dots that a placed piece covers, or that lie too far from it; false when
/// none is left.
bool CompleteSearch::leaves(Level* level, const Value& value, int item) {
  bool any = false;
  for (const int s : slots_of_[item]) {
    const Slot& slot = slots_[s];
    const BitTable& bits = bitsOf(slots_[value.slot].placed, slot.placed);
    std::uint64_t* rows = level->domains.data() + rowAt(s, rows_.lo);
    reads_ += rows_.size();
    for (int j = rows_.lo; j <= rows_.hi; ++j) {
      std::uint64_t& row = rows[j - rows_.lo];
      if (row == 0) continue;
      const double up = j * pieces_.board().up.y();
      if (slot.low + up < level->bottom - kSameHeight ||
          slot.high + up > level->top + kSameHeight) {
        row = 0;
        continue;
      }
      const int of = j - value.dot.j;
      if (of >= bits.rows.lo && of <= bits.rows.hi)
        row &= ~bits.window(of, bases_[j - rows_.lo] - value.dot.i - bits.column);
      any = any || row != 0;
    }
  }
  return any;
}

/// Goes one level down, unless that leaves some piece without a dot.
void CompleteSearch::place(const Value& value) {
  const Slot& slot = slots_[value.slot];
  const double up = value.dot.j * pieces_.board().up.y();
  Level next;
  next.domains = levels_.back().domains;
  next.bottom = std::max(levels_.back().bottom, slot.high + up - length_);
  next.top = std::min(levels_.back().top, slot.low + up + length_);
  places_[value.item] = {slot.way, value.dot};
  bool is_open = false;
  for (std::size_t item = 0; item < places_.size(); ++item) {
    if (places_[item].way >= 0) continue;
    is_open = true;
    if (leaves(&next, value, static_cast<int>(item))) continue;
    ++failures_[item];
    places_[value.item] = {};
    return;
  }
  if (!is_open) {
    LaidPieces layout{places_};
    measure(pieces_, cloth_, &layout);
    found_ = layout;
    return;
  }
  next.values = valuesOf(next, nextItem(next));
  placed_.push_back(value.item);
  levels_.push_back(std::move(next));
}

bool CompleteSearch::step(double reads) {
  const double end = reads_ + reads;
  while (reads_ < end && !found_) {
    if (levels_.empty()) return false;
    reads_ += 1;
    Level& level = levels_.back();
    if (level.next > 0) removeLike(&level, level.values[level.next - 1]);
    if (level.next == level.values.size()) {
      levels_.pop_back();
      if (placed_.empty()) continue;
      places_[placed_.back()] = {};
      placed_.pop_back();
      continue;
    }
    place(level.values[level.next++]);
  }
  return !found_;
}

}  // namespace seamwise
