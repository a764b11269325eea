#include "nesting/complete_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace seamwise {
namespace {

constexpr int kBits = 64;
constexpr double kSameHeight = 1e-6;      // cm
constexpr std::size_t kAllBeginnings = 100000;

}  // namespace

CompleteSearch::CompleteSearch(const PiecesOnBoard& pieces, const LayCloth& cloth, double length)
    : pieces_(pieces), cloth_(cloth), length_(length), ways_(allowedWays(pieces, cloth)) {
  const bool repeats = pieces.board().along.y() == 0 && pieces.period();
  if (pieces.isFine() || !(repeats || cloth.is_fixed)) return;
  beginnings_ = beginnings(pieces, cloth, kAllBeginnings);
  slots_of_.resize(ways_.size());
  for (std::size_t item = 0; item < ways_.size(); ++item) {
    for (const int way : ways_[item]) {
      slots_of_[item].push_back(static_cast<int>(slots_.size()));
      slots_.push_back({static_cast<int>(item), way, pieces.items()[item].ways[way].placed});
    }
  }
  bits_.resize(static_cast<std::size_t>(pieces.placedCount()) * pieces.placedCount());
  places_.resize(ways_.size());
  can_prove_ = std::all_of(beginnings_.begin(), beginnings_.end(),
                           [&](double bottom) { return setRows(bottom); });
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
      if (table.row(j)[k] > 0)
        bits.bits[static_cast<std::size_t>(j - bits.rows.lo) * bits.words + k / kBits] |=
            std::uint64_t{1} << (k % kBits);
  return bits;
}

/// The rows of a window and the domains in it; false when a row does not go into a word.
bool CompleteSearch::setRows(double bottom) {
  const Window window{cloth_.left, cloth_.right, bottom, bottom + length_};
  domains_.clear();
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

/// Goes on to the next height to begin at; false when there is none.
bool CompleteSearch::openWindow() {
  while (window_ < beginnings_.size()) {
    const double bottom = beginnings_[window_++];
    setRows(bottom);
    if (rows_.empty()) continue;
    Level level;
    level.domains.assign(slots_.size() * rows_.size(), 0);
    for (std::size_t s = 0; s < slots_.size(); ++s) {
      const auto flaws = pieces_.flawTables(slots_[s].placed, cloth_.origin);
      for (int j = domains_[s].first; j <= domains_[s].rows().hi; ++j) {
        const DotRun& run = domains_[s].row(j);
        for (int i = run.lo; i <= run.hi; ++i) {
          const bool is_flawed =
              std::any_of(flaws.begin(), flaws.end(),
                          [&](const DifferenceTable& flaw) { return flaw.depth({i, j}) > 0; });
          if (!is_flawed)
            rowOf(&level, static_cast<int>(s), j) |= std::uint64_t{1} << (i - bases_[j - rows_.lo]);
        }
      }
    }
    if (cloth_.is_fixed) {
      const int item = fewest(level);
      if (item < 0) continue;
      level.values = valuesOf(level, item);
    } else {  // some piece is the lowest, and lies at the very bottom
      for (std::size_t item = 0; item < ways_.size(); ++item) {
        if (pieces_.items()[item].like != static_cast<int>(item)) continue;
        for (const Value& value : valuesOf(level, static_cast<int>(item))) {
          const int placed = pieces_.items()[item].ways[value.place.way].placed;
          if (pieces_.bottomAt(placed, value.place.dot, cloth_.origin) < bottom + kSameHeight)
            level.values.push_back(value);
        }
      }
    }
    levels_.push_back(std::move(level));
    return true;
  }
  return false;
}

std::vector<CompleteSearch::Value> CompleteSearch::valuesOf(const Level& level, int item) const {
  std::vector<Value> values;
  for (int j = rows_.lo; j <= rows_.hi; ++j) {
    for (const int slot : slots_of_[item]) {
      std::uint64_t bits =
          level.domains[static_cast<std::size_t>(slot) * rows_.size() + (j - rows_.lo)];
      for (; bits != 0; bits &= bits - 1) {
        const int i = bases_[j - rows_.lo] + std::countr_zero(bits);
        values.push_back({item, {slots_[slot].way, {i, j}}});
      }
    }
  }
  return values;
}

/// The item not placed yet that has the fewest dots; -1 when one has none, or when all are placed.
int CompleteSearch::fewest(const Level& level) const {
  int best = -1, least = std::numeric_limits<int>::max();
  for (std::size_t item = 0; item < places_.size(); ++item) {
    if (places_[item].way >= 0) continue;
    int count = 0;
    for (const int slot : slots_of_[item]) {
      const std::uint64_t* rows =
          level.domains.data() + static_cast<std::size_t>(slot) * rows_.size();
      for (int j = 0; j < rows_.size(); ++j) count += std::popcount(rows[j]);
    }
    if (count == 0) return -1;
    if (count >= least) continue;
    least = count;
    best = static_cast<int>(item);
  }
  return best;
}

/// Every layout with the item there has been looked at, and so with an equal item.
void CompleteSearch::removeLike(Level* level, const Value& value) const {
  const int like = pieces_.items()[value.item].like;
  const int j = value.place.dot.j;
  const std::uint64_t bit = std::uint64_t{1} << (value.place.dot.i - bases_[j - rows_.lo]);
  const int placed = pieces_.items()[value.item].ways[value.place.way].placed;
  for (std::size_t s = 0; s < slots_.size(); ++s)
    if (pieces_.items()[slots_[s].item].like == like && slots_[s].placed == placed)
      rowOf(level, static_cast<int>(s), j) &= ~bit;
}

/// Goes one level down, unless that leaves some piece without a dot.
void CompleteSearch::place(const Value& value) {
  places_[value.item] = value.place;
  Level next;
  next.domains = levels_.back().domains;
  const int placed = pieces_.items()[value.item].ways[value.place.way].placed;
  bool is_open = false;
  for (std::size_t s = 0; s < slots_.size(); ++s) {
    if (places_[slots_[s].item].way >= 0) continue;
    is_open = true;
    reads_ += rows_.size();
    const BitTable& bits = bitsOf(placed, slots_[s].placed);
    const int from = std::max(rows_.lo, value.place.dot.j + bits.rows.lo);
    const int to = std::min(rows_.hi, value.place.dot.j + bits.rows.hi);
    std::uint64_t* rows = next.domains.data() + s * rows_.size();
    for (int j = from; j <= to; ++j) {
      if (rows[j - rows_.lo] == 0) continue;
      const int start = bases_[j - rows_.lo] - value.place.dot.i - bits.column;
      rows[j - rows_.lo] &= ~bits.window(j - value.place.dot.j, start);
    }
  }
  if (!is_open) {
    LaidPieces layout{places_};
    measure(pieces_, cloth_, &layout);
    found_ = layout;
    return;
  }
  const int item = fewest(next);
  if (item < 0) {
    places_[value.item] = {};
    return;
  }
  next.values = valuesOf(next, item);
  placed_.push_back(value);
  levels_.push_back(std::move(next));
}

bool CompleteSearch::step(double reads) {
  const double end = reads_ + reads;
  while (reads_ < end && !found_) {
    if (levels_.empty() && !openWindow()) return false;
    reads_ += 1;
    Level& level = levels_.back();
    if (level.next > 0 && level.next <= level.values.size())
      removeLike(&level, level.values[level.next - 1]);
    if (level.next >= level.values.size()) {
      levels_.pop_back();
      if (!placed_.empty()) {
        places_[placed_.back().item] = {};
        placed_.pop_back();
      }
      continue;
    }
    const Value value = level.values[level.next++];
    place(value);
  }
  return !found_;
}

}  // namespace seamwise
