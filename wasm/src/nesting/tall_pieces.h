#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "nesting/pieces_on_board.h"

namespace seamwise {

/// A way of an item, as searches have it that look at all dots.
struct SearchSlot {
  int item, way, placed;
  double low, high;     ///< of the piece in row 0. [cm]
  double middle;        ///< of the piece at dot (0, 0), across the cloth. [cm]
  Domain domain;        ///< all dots
  std::ptrdiff_t row0;  ///< of row 0 among the rows of all slots
  int column(int j) const { return domain.row(j).lo; }  ///< of bit 0
};

/// The slots of a search for layouts of at most some length.
struct SearchSlots {
  std::vector<SearchSlot> slots;
  std::vector<std::vector<int>> of;  ///< per item
  std::vector<DotRun> reaches;       ///< per pair of slots
  std::size_t pair(int from, int to) const { return from * slots.size() + to; }
  /// The rows at which the second lies, less that of the first, with both in that length.
  const DotRun& reach(int from, int to) const { return reaches[pair(from, to)]; }
};

/// The dots that are left to pieces.
struct DotsLeft {
  std::vector<std::uint64_t> bits;  ///< per slot its rows
  std::vector<DotRun> rows;         ///< per slot those that may have dots
};

/// A dot of a slot, and which tall pieces lie up to there from the left, once that is known.
struct SlotDot {
  int slot = -1;
  Dot dot;
  unsigned order = 0;
};

/// Pieces of which no two go above each other within a length: they lie side by side, in an order
/// of the middles of their boxes. Two neighbours in it keep a distance that depends on their rows,
/// for which tables are asked once. What that leaves to the right of a piece for any set of the
/// others, in the best order, ways and rows, is found by dynamic programming over sets.
class TallPieces {
 public:
  /// @param order   items, the tallest first
  /// @param slots   must stay
  TallPieces(const PiecesOnBoard& pieces, const SearchSlots& slots, const std::vector<int>& order,
             double length);

  /// Fewer than three are not worth it.
  bool empty() const { return items_.empty(); }
  unsigned all() const {
    return (1U << items_.size()) - 1;
  }  ///< as a set; the tallest is its bit 0
  /// The last column of each slot's rows at which others find room to the right, with these dots;
  /// false when there is no order in which all find room. @param reads  counted on
  bool setLimits(const DotsLeft& left, double* reads);
  /// Adds all dots at which another piece may lie next in the order.
  /// @param last   of the order; nothing at its beginning
  /// @param laid   pieces that have one dot, wherever in the order; they are passed by
  void addNext(const DotsLeft& left, const SlotDot* last, unsigned laid,
               std::vector<SlotDot>* next) const;

 private:
  int leastColumns(int from, int to, int row) const;
  int lastColumn(const DotsLeft& left, int slot, int row, int limit) const;
  int limitOf(unsigned set, const DotsLeft& left, int slot, int row, double* reads) const;

  const PiecesOnBoard& pieces_;
  const SearchSlots& slots_;
  std::vector<int> items_;
  std::vector<unsigned> before_;         ///< per tall piece equal ones that lie left of it
  std::vector<std::vector<int>> least_;  ///< per pair of slots and row of its reach, columns apart
  std::vector<int> limits_;              ///< per set and row
};

}  // namespace seamwise
