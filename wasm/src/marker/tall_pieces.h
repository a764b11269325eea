#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "marker/pieces_on_board.h"

namespace seamwise {

/// A way of an item in a search that visits all dots.
struct SearchSlot {
  int item, way, placed;
  double low, high;     ///< ends of the piece in row 0. [cm]
  double middle;        ///< middle of the piece at dot (0, 0), across the fabric. [cm]
  Domain domain;        ///< all dots
  std::ptrdiff_t row0;  ///< index of row 0 among the rows of all slots
  int column(int j) const { return domain.row(j).lo; }  ///< column of bit 0
};

/// The slots of a search for layouts of at most a given length.
struct SearchSlots {
  std::vector<SearchSlot> slots;
  std::vector<std::vector<int>> of;  ///< slots per item
  std::vector<DotRun> reaches;       ///< per pair of slots
  std::size_t pair(int from, int to) const { return from * slots.size() + to; }
  /// Rows of the second slot minus the row of the first at which both fit within that length.
  const DotRun& reach(int from, int to) const { return reaches[pair(from, to)]; }
};

/// The remaining dots of pieces.
struct DotsLeft {
  std::vector<std::uint64_t> bits;  ///< rows of all slots
  std::vector<DotRun> rows;         ///< per slot, the rows that may have dots
};

/// A dot of a slot, and the set of tall pieces from the left up to it, if that is known.
struct SlotDot {
  int slot = -1;
  Dot dot;
  unsigned order = 0;
};

/// Pieces of which no two fit above each other within a length. They are side by side, in the order
/// of the middles of their boxes. The distance of two neighbours depends on their rows and is read
/// from the tables only once. Dynamic programming over sets computes the room to the right of a
/// piece for any set of the others, in the best order, ways and rows.
class TallPieces {
 public:
  /// @param order   items, the tallest first
  /// @param slots   must outlive this object
  TallPieces(const PiecesOnBoard& pieces, const SearchSlots& slots, const std::vector<int>& order,
             double length);

  /// True if there are fewer than three tall pieces, which are not worth the work.
  bool empty() const { return items_.empty(); }
  unsigned all() const {
    return (1U << items_.size()) - 1;
  }  ///< set of all tall pieces; the tallest is its bit 0
  /// Computes, for each slot's rows and any set of the others, the last column that leaves these
  /// room to the right. Returns false if no order of all pieces fits.
  /// @param reads   increased by the number of reads
  bool setLimits(const DotsLeft& left, double* reads);
  /// Adds all dots of pieces that may be next in the order.
  /// @param last   last dot of the order; null before the first
  /// @param laid   pieces that already have one dot, anywhere in the order; they are skipped
  void addNext(const DotsLeft& left, const SlotDot* last, unsigned laid,
               std::vector<SlotDot>* next) const;

 private:
  int leastColumns(int from, int to, int row) const;
  int lastColumn(const DotsLeft& left, int slot, int row, int limit) const;
  int limitOf(unsigned set, const DotsLeft& left, int slot, int row, double* reads) const;

  const PiecesOnBoard& pieces_;
  const SearchSlots& slots_;
  std::vector<int> items_;
  std::vector<unsigned> before_;         ///< per tall piece, the equal ones to the left of it
  std::vector<std::vector<int>> least_;  ///< least column distance per pair of slots and row of its
                                         ///< reach
  std::vector<int> limits_;              ///< per set and row
};

}  // namespace seamwise
