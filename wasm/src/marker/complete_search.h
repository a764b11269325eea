#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "marker/layout.h"
#include "marker/tall_pieces.h"

namespace seamwise {

/// Searches all layouts of at most a given length, step by step. It places one piece after the
/// other and stores the remaining dots of the other pieces as bits. Pieces that must be side by
/// side come first, from left to right, as long as all of them fit. The next piece is then the one
/// with the fewest remaining dots; pieces that ran out of dots before get priority. Layouts that
/// differ by whole repeats, or by an exchange of equal pieces, are visited only once.
class CompleteSearch {
 public:
  /// @param length   greatest length of a layout. [cm]
  CompleteSearch(const PiecesOnBoard& pieces, const LayFabric& fabric, double length);

  /// True if the end of the search is a proof: the board has all dots, rows are level, they repeat
  /// or the cut is fixed, and none has more than 64 dots. Otherwise `step` must not be called.
  bool canProve() const { return can_prove_; }
  /// Visits about `reads` more rows. Returns false when the search has ended.
  bool step(double reads);
  /// The layout found; empty if there is none of that length. Valid after the end of the search.
  const std::optional<LaidPieces>& found() const { return found_; }
  /// Number of rows of dots visited so far.
  double reads() const { return reads_; }

 private:
  static constexpr int kBits = 64;  ///< bits of a word, one per dot

  struct BitTable {
    DotRun rows;
    int column = 0;  ///< column of bit 0
    int words = 0;   ///< words per row; the first and the last are empty
    std::vector<std::uint64_t> bits;
    std::uint64_t window(int row, int start) const;
  };
  /// A level of the search. It tries the dots of one piece, or of all candidates for the next piece
  /// side by side.
  struct Level {
    DotsLeft left;
    std::vector<int> counts;  ///< per unplaced item, the number of its dots
    std::vector<SlotDot> values;
    std::size_t next = 0;
    bool is_of_one = true;  ///< all values are of one piece
  };

  bool setSlots(const Window& window);
  std::vector<int> tallestFirst() const;
  void begin();
  void place(const SlotDot& value);
  bool mayPoint(const SearchSlot& slot, const SearchSlot& other) const;
  bool leaves(Level* level, const SlotDot& value, int item);
  bool setNext(Level* level, const SlotDot* last);
  void setValues(Level* level, int item, unsigned order) const;
  void removeLike(Level* level, const SlotDot& value) const;
  int nextItem(const Level& level) const;
  const BitTable& bitsOf(int first, int second);

  const PiecesOnBoard& pieces_;
  LayFabric fabric_;
  double length_;
  bool can_prove_ = false;
  SearchSlots slots_;
  std::vector<std::uint64_t> dots_;  ///< all dots
  std::vector<int> order_;           ///< items, the tallest first
  std::optional<TallPieces> tall_;
  std::vector<BitTable> bits_;
  std::vector<Level> levels_;  ///< per piece
  std::size_t depth_ = 0;      ///< number of levels in use
  std::vector<LayPlace> places_;
  std::vector<double> failures_;  ///< per item, 1 plus the number of times it ran out of dots
  std::vector<int> likely_;       ///< items, the last one that ran out of dots first
  std::optional<LaidPieces> found_;
  double reads_ = 0;
};

}  // namespace seamwise
