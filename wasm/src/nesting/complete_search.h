#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "nesting/layout.h"
#include "nesting/tall_pieces.h"

namespace seamwise {

/// Looks through all layouts of at most a given length, step by step: one piece after the other,
/// with the dots that each leaves to the others as bits. Pieces that have to lie side by side come
/// first, from left to right, as long as all find room; then that with the fewest dots left, where
/// pieces that ran out of dots before count more. Layouts that differ by whole repeats, or by
/// which of two equal pieces lies where, are looked at once.
class CompleteSearch {
 public:
  /// @param length   that no layout sought exceeds. [cm]
  CompleteSearch(const PiecesOnBoard& pieces, const LayCloth& cloth, double length);

  /// Whether its end proves anything: the board has all dots, rows are level, they repeat or the
  /// cut is fixed, and none has more than 64 dots. Otherwise `step` must not be called.
  bool canProve() const { return can_prove_; }
  /// Goes on until about so many rows are looked at; false when it has ended.
  bool step(double reads);
  /// Once it has ended: the layout it has found; nothing when there is none of that length.
  const std::optional<LaidPieces>& found() const { return found_; }
  /// Rows of dots looked at so far.
  double reads() const { return reads_; }

 private:
  static constexpr int kBits = 64;  ///< of a word, one a dot

  struct BitTable {
    DotRun rows;
    int column = 0;  ///< of bit 0
    int words = 0;   ///< of a row, the first and the last of them empty
    std::vector<std::uint64_t> bits;
    std::uint64_t window(int row, int start) const;
  };
  /// A piece has been chosen, or the next of those side by side is to be: dots tried one by one.
  struct Level {
    DotsLeft left;
    std::vector<int> counts;  ///< per item of its dots, where it is not placed
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
  LayCloth cloth_;
  double length_;
  bool can_prove_ = false;
  SearchSlots slots_;
  std::vector<std::uint64_t> dots_;  ///< all
  std::vector<int> order_;           ///< items, the tallest first
  std::optional<TallPieces> tall_;
  std::vector<BitTable> bits_;
  std::vector<Level> levels_;  ///< per piece
  std::size_t depth_ = 0;      ///< of these, in use
  std::vector<LayPlace> places_;
  std::vector<double> failures_;  ///< per item, how often it ran out of dots, and 1
  std::vector<int> likely_;       ///< items, that which ran out of dots last first
  std::optional<LaidPieces> found_;
  double reads_ = 0;
};

}  // namespace seamwise
